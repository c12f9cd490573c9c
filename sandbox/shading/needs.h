#pragma once

#include "shading/features.h"

/// What each stage of a program computes, is given and passes on; derived from the program's features alone.
namespace sandbox {

/// How one stage deals with the lights of one kind.
struct LightNeeds {
    bool any = false; ///< this stage adds some term of theirs
    bool adds_ambient = false, adds_attenuated_ambient = false, adds_diffuse = false, adds_specular = false;
    bool uses_n_dot_l = false;
    bool uses_L = false, finds_L = false, given_L = false;
    bool given_H = false, given_R = false; ///< interpolated, per light
    bool finds_distance = false, given_distance = false;
    bool finds_attenuation = false, given_attenuation = false;
    bool uses_cone = false;
    bool fades = false; ///< some term is multiplied by attenuation or cone
    bool uses_N = false, uses_V = false;
    bool uses_R = false; ///< the mirrored view direction, found once per point

    [[nodiscard]] bool uses_P() const { return finds_L || finds_distance; }
    [[nodiscard]] bool given_any() const {
        return given_L || given_H || given_R || given_distance || given_attenuation;
    }
};

struct StageNeeds {
    bool lit = false;                                        ///< the lighting equation runs here
    bool ambient = false, diffuse = false, specular = false; ///< the terms of the lights that it adds
    bool constant_ambient = false;
    bool P = false, N = false, V = false, R = false;
    bool separate_specular = false; ///< specular light that no base colour multiplies
    ByLightKind<LightNeeds> lights;
};

/// Which vertex attributes a program reads beside positions (locations as in vertex.glsl), and in which arrangement.
struct VertexAttributes {
    bool flat = false; ///< unshared vertices that carry their face's normal and centroid
    bool normal = false, uv = false, centroid = false, color = false;
    auto operator<=>(const VertexAttributes &) const = default; // NOLINT(modernize-use-nullptr): version 14 errs
};

struct ProgramNeeds {
    StageNeeds vertex, fragment;
    bool vectors = false;    ///< interpolated-vectors
    bool both_sides = false; ///< vertices are lit as seen from the front and as seen from the back; the pixel chooses
    VertexAttributes attributes;
};

/// `program`: see program_features().
ProgramNeeds derive_needs(const Features &program);

/// Components of the varyings between the stages of a specialised program; more than 60 are refused.
int varying_components(const Features &features);

/// Throws InputError, naming the object, if more must pass between the stages of its program than there is room for.
void require_drawable(const Features &features, const Object &object);

constexpr int max_varying_components = 60; ///< OpenGL 3.3 guarantees 60 (64 less gl_Position)

} // namespace sandbox

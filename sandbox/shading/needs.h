#pragma once

#include "shading/features.h"
#include "shading/program_source.h"

/// What each stage of a program computes, is given and passes on; derived from the features alone.
namespace sandbox {

/// How one stage deals with the lights of one type.
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
};

struct StageNeeds {
    bool lit = false;                                        ///< the lighting equation runs here
    bool ambient = false, diffuse = false, specular = false; ///< the terms of the lights that it adds
    bool constant_ambient = false;
    bool P = false, N = false, V = false, R = false;
    bool separate_specular = false; ///< specular light that no base colour multiplies
    LightNeeds directional, point, spot;
};

struct ProgramNeeds {
    StageNeeds vertex, fragment;
    bool vectors = false; ///< interpolated-vectors
};

ProgramNeeds derive_needs(const Features &features);

} // namespace sandbox

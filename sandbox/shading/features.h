#pragma once

#include "scene/mesh.h"
#include "scene/resources.h"
#include "scene/scene.h"
#include "shading/technique.h"

#include <compare>
#include <cstddef>
#include <vector>

/// What one object of a scene needs under a technique. A feature that is absent leaves no line, uniform, varying or
/// attribute behind in the program. Equal features give equal text.
namespace sandbox {

/// What the lights of one type need, together.
struct LightFeatures {
    int count = 0;
    bool ambient = false;            ///< an ambient term beside the shared constant: only where lit
    bool attenuated_ambient = false; ///< an ambient term times attenuation and cone
    bool diffuse = false;
    bool specular = false;
    bool constant = false; ///< attenuation coefficients that are in use
    bool linear = false;
    bool quadratic = false;
    bool floor = false;             ///< the denominator can fall below its floor
    bool on_surface = false;        ///< a light may lie on the surface: L = N where d = 0
    bool given_half_vector = false; ///< one H per light, the same everywhere
    bool narrow_cone = false;       ///< some cone or soft edge is too narrow for float32 cosines
    bool hard_cone = false;         ///< some cone has a hard edge
    bool soft_cone = false;         ///< some cone has an inner cone
    bool exponent = false;          ///< some spot exponent is not 0
    bool no_exponent = false;       ///< ... and some are 0
    bool stable_exponent = false;
    auto operator<=>(const LightFeatures &) const = default; // NOLINT(modernize-use-nullptr): version 14 errs

    [[nodiscard]] bool attenuated() const { return constant || linear || quadratic; }
};

enum class Base { none, texture, checker };
/// How a vertex normal becomes a world one; `model_matrix` and the last are faults, where they show.
enum class NormalTransform { identity, rigid, normal_matrix, model_matrix, untransformed };
enum class Exponent { zero, one, textbook, stable };

struct Features {
    Program program = Program::specialised;
    Frequency frequency = Frequency::per_pixel;
    Model model = Model::lambert; ///< lambert where nothing is specular
    LightFeatures directional, point, spot;
    bool ambient = false;  ///< a constant ambient (and emission, where no base colour multiplies it)
    bool emission = false; ///< emission beside a base colour
    Base base = Base::none;
    bool base_times_specular = false;
    bool normals = false; ///< anything depends on N
    NormalTransform normal_transform = NormalTransform::identity;
    bool renormalize = false;
    bool guard_normal = false;        ///< interpolated normals may cancel to 0
    bool guard_vertex_normal = false; ///< the transform may leave nothing of a normal, or nothing float32 can square
    Exponent exponent = Exponent::zero;
    Gate gate = Gate::light_facing;
    Viewer viewer = Viewer::local;
    LightingPosition position = LightingPosition::world;
    bool where_lit = false;
    bool unnegated_diffuse = false;
    AttenuationAt attenuation = AttenuationAt::exact;
    bool two_sided = false;
    bool wide = false; ///< positions are found from the pixel, not interpolated
    bool deep = false; ///< depth is stored as a logarithm
    bool object_ids = false;
    auto operator<=>(const Features &) const = default; // NOLINT(modernize-use-nullptr): version 14 errs

    [[nodiscard]] bool specular() const { return directional.specular || point.specular || spot.specular; }
    [[nodiscard]] bool diffuse() const { return directional.diffuse || point.diffuse || spot.diffuse; }
};

/// The lights that reach this object at all, by type, as indices into scene.lights. A spot with cutoff 180 is a point
/// light.
struct ContributingLights {
    std::vector<std::size_t> directional, point, spot;
};
/// Does anything about the light depend on where it is (attenuation, cone)?
bool fades(const Light &light);
/// Must its ambient term be evaluated with the light? The rest is summed into one constant.
bool ambient_with_light(const Light &light, const Technique &technique);

ContributingLights contributing_lights(const Scene &scene, const Technique &technique, const Object &object);

/// The one pure function that decides what a program holds. `mesh` is the object's; its normals decide guards. `deep`:
/// what is_deep(scene, all resources) says; the camera alone may make it so too.
Features derive_features(const Scene &scene, const Technique &technique, const Object &object, const Mesh &mesh,
                         bool object_ids = false, bool deep = false);
/// Of every object of the scene, in their order, without object ids.
std::vector<Features> derive_features(const Scene &scene, const Technique &technique,
                                      const std::vector<ObjectResources> &resources);

NormalTransform normal_transform(const Technique &technique, const Object &object);
/// Where lengths are scaled (length_scale.h) the model matrix is no longer rigid.
NormalTransform scaled(NormalTransform transform, double length_scale);

/// Components of the varyings between the stages; more than 60 are refused.
int varying_components(const Features &features);

/// n as it is raised: blinn_exponent_scale * shininess under Blinn-Phong.
double raised_exponent(const Scene &scene, Model model, const Material &material);

/// The textbook's program of the same scene: no guard, no stable power. For measuring what they cost.
Features without_guards(Features features);

/// Throws InputError if the object needs more varyings than there are, naming it. `features` are what derive_features
/// gave.
void require_drawable(const Features &features, const Scene &scene, const Technique &technique, const Object &object);

constexpr double stable_power_from = 1024; ///< power=auto: the stable form from this n on
constexpr int max_varying_components = 60; ///< OpenGL 3.3 guarantees 60 (64 less gl_Position)
constexpr int full_program_max_lights = 64;
constexpr int full_program_max_vector_lights = 7; ///< interpolated-vectors: 7 components a light, and 11 besides

} // namespace sandbox

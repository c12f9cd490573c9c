#pragma once

#include "scene/light_kind.h"
#include "scene/mesh.h"
#include "scene/scene.h"
#include "shading/eye_space.h"
#include "shading/object_lights.h"
#include "shading/technique.h"

#include <algorithm>
#include <compare>

/// What one object of a scene needs under a technique. A feature that is absent leaves no line, uniform, varying or
/// attribute behind in the program. Equal features give equal text.
namespace sandbox {

/// What the lights of one kind need, together.
struct LightFeatures {
    int count = 0;
    bool ambient = false;            ///< an ambient term beside the shared constant: only where lit
    bool attenuated_ambient = false; ///< an ambient term times attenuation and cone
    bool diffuse = false;
    bool specular = false;
    bool one_color = false; ///< of each light, specular is so many times diffuse
    bool one_share = false; ///< ... and of all as many
    bool constant = false;  ///< attenuation coefficients that are in use
    bool linear = false;
    bool quadratic = false;
    bool one_attenuation = false;   ///< several lights, all with the same coefficients
    bool floor = false;             ///< the denominator can fall below its floor
    bool on_surface = false;        ///< a light may lie on the surface: L = N where d = 0
    bool given_half_vector = false; ///< one H per light, the same everywhere
    bool opposite = false;          ///< a light may stand just opposite the viewer: L = -V, and H = 0
    bool narrow_cone = false;       ///< some cone or soft edge is too narrow for float32 cosines
    bool hard_cone = false;         ///< some cone has a hard edge
    bool soft_cone = false;         ///< some cone has an inner cone
    bool exponent = false;          ///< some cone's exponent is not 0
    bool no_exponent = false;       ///< ... and some are 0
    bool stable_exponent = false;
    auto operator<=>(const LightFeatures &) const = default; // NOLINT(modernize-use-nullptr): version 14 errs

    [[nodiscard]] bool attenuated() const { return constant || linear || quadratic; }
    [[nodiscard]] bool cone() const { return hard_cone || soft_cone; }
};

/// How a vertex normal becomes a world one, faults apart.
enum class NormalTransform { identity, rigid, general };
enum class Exponent { zero, one, textbook, stable };

/// Of the model `own`, what its text leaves open.
struct OwnFeatures {
    int lights = 0;     ///< the length of its array
    bool moved = false; ///< position() is handed vertices whose buffers are measured from elsewhere than their origin
    auto operator<=>(const OwnFeatures &) const = default; // NOLINT(modernize-use-nullptr): version 14 errs
};

struct Features {
    Technique technique; ///< as far as it shows: a key that changes no pixel here stands at its default
    ByLightKind<LightFeatures> lights;
    bool ambient = false;   ///< a constant ambient (and emission, where no base colour multiplies it)
    bool emission = false;  ///< emission beside a base colour
    bool textured = false;  ///< the base colour comes from a texture
    bool chequered = false; ///< ... or from a checker
    bool colored = false;   ///< the base colour is multiplied by the vertices'
    bool base_times_specular = false;
    bool normals = false; ///< anything depends on N
    NormalTransform normal_transform = NormalTransform::identity;
    bool guard_normal = false;        ///< interpolated normals may cancel to 0
    bool guard_vertex_normal = false; ///< the transform may leave nothing of a normal, or nothing float32 can square
    Exponent exponent = Exponent::zero;
    int whole_exponent = 0;    ///< n where it is written in, and raised by multiplications; 0: by pow()
    bool two_sided = false;    ///< N is turned; technique.facing says where
    bool orthographic = false; ///< that technique.viewer is infinite is no fault
    bool afar = false;         ///< positions are measured from the object's middle, not from the eye
    bool wide = false;         ///< positions are found from the pixel, not interpolated
    bool deep = false;         ///< depth is stored as a logarithm
    bool mediump = false;      ///< GLSL ES: the fragment stage's floats are declared so
    bool invariant = false;    ///< another program draws the triangles beside: no pixel between may be missed
    OwnFeatures own;
    bool object_ids = false;
    bool shown = false;                                 ///< writes what a screen shows, not linear light:
    bool srgb = false;                                  ///< by this curve
    bool exposed = false;                               ///< with an exposure other than 1
    auto operator<=>(const Features &) const = default; // NOLINT(modernize-use-nullptr): version 14 errs

    [[nodiscard]] bool is_own() const { return technique.model == Model::own; }
    [[nodiscard]] bool is_full() const { return technique.program == Program::full; }
    [[nodiscard]] bool is_baked() const { return technique.program == Program::baked; }
    /// Are positions measured from elsewhere than the eye?
    [[nodiscard]] bool off_eye() const { return afar || technique.position == LightingPosition::absolute; }
    [[nodiscard]] bool has_base() const { return textured || chequered || colored; }
    /// Is R.V raised, or N.H? A full program can do both.
    [[nodiscard]] bool mirrors_view() const { return is_full() || sandbox::mirrors_view(technique.model); }
    [[nodiscard]] bool uses_half_vector() const { return is_full() || reflection(technique.model).half_vector; }
    /// Is N turned to the viewer where N.V < 0? A full program can do that too.
    [[nodiscard]] bool turns_by_view() const { return two_sided && (is_full() || technique.facing == Facing::view); }
    [[nodiscard]] bool turns_by_winding() const {
        return two_sided && (is_full() || technique.facing == Facing::winding);
    }
    [[nodiscard]] bool specular() const { return std::ranges::any_of(lights, &LightFeatures::specular); }
    [[nodiscard]] bool diffuse() const { return std::ranges::any_of(lights, &LightFeatures::diffuse); }
};

/// The one pure function that decides what an object needs. `lights` are those that reach it; `mesh` is the object's,
/// whose normals and bounds decide guards.
Features derive_features(const Scene &scene, const Technique &technique, const Object &object, const Mesh &mesh,
                         const ObjectLights &lights, const EyeSpace &space);

/// What the program of an object with these features holds: the same or, in a full program, everything.
Features program_features(const Features &object);

/// How many lights the arrays of a full program hold; `colored`: of one that reads vertices' colours.
int full_program_capacity(Frequency frequency, bool colored);
/// What a full program does for lights of a kind.
LightFeatures every_light_feature(const LightKind &kind, const Features &program);

/// The textbook's program of the same scene: no guard, no stable power. For measuring what they cost.
Features without_guards(Features features);

/// n as it is raised: times the scene's blinn_exponent_scale where the model measures from the half vector.
double raised_exponent(const Scene &scene, Model model, const Material &material);

/// Whether power= asks for the stable form of f^n: `stable`, or `auto` from stable_power_from on.
bool asks_for_stable_power(const Technique &technique, double n);

/// How f^n is found; `normals`: as far as the key shows.
Exponent exponent_kind(const Technique &technique, Normals normals, double n);

constexpr double stable_power_from = 1024; ///< power=auto: the stable form from this n on

} // namespace sandbox

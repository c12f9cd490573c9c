#pragma once

#include "certificate/interpolation_bound.h"
#include "scene/scene.h"
#include "shading/object_lights.h"
#include "shading/technique.h"

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

/// By how much a triangle that is lit at its corners may differ from the same triangle lit at every point.
namespace sandbox::certificate {

/// One light on one object. World axes, the eye as the origin.
struct BoundLight {
    std::size_t index = 0; ///< in scene.lights
    bool positional = true;
    bool cone = false;
    glm::dvec3 position{0}, travel{0}; ///< travel: unit
    Attenuation attenuation;
    double cos_outer = -1, cos_inner = -1, cone_exponent = 0; ///< equal cosines: a hard edge
    glm::dvec3 half{0};                                       ///< of half_vector=constant
    double diffuse_sign = 1;                                  ///< -1: direction=unnegated-diffuse
    bool ambient_fades = true;                                ///< the ambient term is attenuated, too
    /// What each term, at most 1 beside attenuation, is multiplied by: light, material and the largest base colour.
    glm::dvec3 ambient{0}, diffuse{0}, specular{0};
};

/// float32 may take a branch's other side where a cosine is this near to its edge, or so many times as near as the
/// direction to the light has roundings.
constexpr double branch_width = 8 * 0x1p-24;

/// What the bound needs to know of an object, its lights and the technique.
struct BoundObject {
    Technique technique;
    std::vector<BoundLight> lights;
    double constant = 0;            ///< light of any channel that is the same everywhere: no more than this
    double exponent = 0;            ///< of f, as it is raised
    std::optional<glm::dvec3> view; ///< V where it is the same at every point
    bool unit_normals = true;       ///< N is made unit per pixel
    /// Body and highlight are multiplied by different colours, the body's by anything from 0 to the largest: what of
    /// their errors cancels at the largest need not cancel elsewhere.
    bool highlight_apart = false;
    bool two_sided = false; ///< N is turned, where technique.facing says
};

struct BoundTriangle {
    Linear position, normal; ///< as lit, from the eye; at the corners
};

/// Over all points of a triangle and all channels.
struct Bound {
    double interpolation = 0; ///< an upper bound of the difference in exact arithmetic; infinite where nothing is known
    /// What float32 rounds: no more light than this comes from ambient and diffuse terms and from specular ones, times
    /// how many roundings its direction and its cone have.
    double body = 0, highlight = 0;
    LightSet lights = every_light; ///< that may add something to some point
};

/// A term that jumps counts with all of its height, one with a kink with the kink's. What the second derivatives alone
/// cannot bring down to `wanted` is narrowed by the error itself at up to 45 points, as long as that may succeed.
constexpr int most_steps = 8;
Bound shading_bound(const BoundObject &object, const BoundTriangle &triangle, double wanted);

} // namespace sandbox::certificate

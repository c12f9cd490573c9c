#pragma once

#include "scene/scene.h"

#include <array>
#include <cstddef>
#include <set>
#include <string_view>
#include <vector>

/// What is marked apart. Light is linear in its ambient, diffuse and specular intensities, so each of these is judged
/// in a scene in which it shines alone; what multiplies light (attenuation, cones) by the ratio of pictures with it and
/// without it.
namespace sandbox {

enum class MarkTerm { ambient, diffuse, specular, attenuation, cone, normals, sum, robustness };
constexpr std::size_t term_count = 8;

/// As exercises write them.
inline constexpr std::array<std::string_view, term_count> term_words{"ambient", "diffuse", "specular", "attenuation",
                                                                     "cone",    "normals", "sum",      "robustness"};

/// A term of light itself, and its intensity.
struct LightTerm {
    MarkTerm term;
    double Light::*intensity;
};
inline constexpr std::array<LightTerm, 3> light_terms{{{MarkTerm::ambient, &Light::ambient},
                                                       {MarkTerm::diffuse, &Light::diffuse},
                                                       {MarkTerm::specular, &Light::specular}}};

using MarkTerms = std::set<MarkTerm>;

/// Every intensity is 0, and so is the scene's ambient light; what shines by itself stays.
Scene dark(Scene scene);
/// Light number `light` stands first and keeps `terms` alone; the others are dark, but there: the number of lights
/// stays, and who reads only the first one reads this one.
Scene only_light(const Scene &scene, std::size_t light, const MarkTerms &terms);
/// All lights keep `terms` alone; the scene's ambient light belongs to MarkTerm::ambient.
Scene only_terms(Scene scene, const MarkTerms &terms);
/// The scene's ambient light alone.
Scene only_scene_ambient(const Scene &scene);

/// Attenuation is 1; cones reach all that lies before the light; objects are neither scaled nor turned. Each as far as
/// it is among `terms`.
Scene neutral(Scene scene, const MarkTerms &terms);

/// Can the term be seen in light number `light`, under any material?
bool light_has(const Light &light, MarkTerm term);

} // namespace sandbox

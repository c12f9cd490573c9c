#pragma once

#include "measure/stability/stability.h"

#include <initializer_list>

/// The table of cases, by group; stability_cases() joins them.
namespace sandbox::stability {

std::vector<StabilityCase> exponent_cases();
std::vector<StabilityCase> geometry_cases();
std::vector<StabilityCase> attenuation_cases();
std::vector<StabilityCase> spot_cases();
std::vector<StabilityCase> transform_cases();
std::vector<StabilityCase> vertex_cases();
std::vector<StabilityCase> placement_cases();
std::vector<StabilityCase> magnitude_cases();

/// One 8-bit level.
constexpr double one_level = 1.0 / 255;

/// An object at the origin, seen from (0, 0, 4).
Scene scene_of(const Shape &shape, std::vector<Light> lights);
Light point_light(const glm::dvec3 &position);
Light directional_light(const glm::dvec3 &direction);
Light spot_light(const glm::dvec3 &position, const glm::dvec3 &direction, double cutoff_degrees);

std::vector<Technique> techniques(std::initializer_list<const char *> texts);
/// Per pixel by both models, by the full program, and per vertex: where most equations run.
std::vector<Technique> usual_techniques();
/// The usual ones and every other frequency.
std::vector<Technique> all_frequencies();

} // namespace sandbox::stability

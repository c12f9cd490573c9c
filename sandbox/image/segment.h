#pragma once

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace sandbox {

/// From p to the nearest point of the segment from a to b.
inline double distance_to_segment(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) {
    const glm::dvec2 along = b - a;
    const double length_squared = glm::dot(along, along);
    const double t = length_squared > 0 ? std::clamp(glm::dot(p - a, along) / length_squared, 0.0, 1.0) : 0;
    return glm::distance(p, a + t * along);
}

} // namespace sandbox

#include "scene/unit.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace sandbox {

glm::dvec3 unit_or(const glm::dvec3 &v, const glm::dvec3 &otherwise) {
    const double square = glm::dot(v, v);
    if (square > 1e-200 && square < 1e200) {
        return v / std::sqrt(square);
    }
    const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (!(largest > 0)) {
        return otherwise;
    }
    const glm::dvec3 scaled = v / largest;
    return scaled / glm::length(scaled);
}

glm::dvec3 unit(const glm::dvec3 &v) { return unit_or(v, glm::dvec3(0)); }

double cos_degrees(double degrees) { return degrees == 90 ? 0 : std::cos(glm::radians(degrees)); }

} // namespace sandbox

#pragma once

#include <glm/vec3.hpp>

/// Directions and angles as a scene means them, in double.
namespace sandbox {

/// v / |v| without overflow or underflow on the way; `otherwise` for 0.
glm::dvec3 unit_or(const glm::dvec3 &v, const glm::dvec3 &otherwise);
/// 0 for 0.
glm::dvec3 unit(const glm::dvec3 &v);

/// The cosine of an angle in degrees: exactly 0 at 90, where std::cos leaves 6e-17.
double cos_degrees(double degrees);

} // namespace sandbox

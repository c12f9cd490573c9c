#pragma once

#include "scene/scene.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

/// The shapes themselves, without triangles: where a ray in object space meets them.
namespace sandbox::reference {

struct ShapeHit {
    double t = 0; ///< the point is origin + t direction
    glm::dvec3 position{0};
    glm::dvec3 normal{0}; ///< unit, outward, as the mesh of the shape has it
    glm::dvec2 uv{0};     ///< as the mesh of the shape has it
    bool back = false;    ///< the ray meets it from behind its normal
    int part = 0;         ///< which face of a box, side or cap of a cylinder: what a crease divides
};

/// The first hit with low <= t <= high. `direction` need not be unit. Not for OBJ files.
std::optional<ShapeHit> intersect(const Shape &shape, const glm::dvec3 &origin, const glm::dvec3 &direction, double low,
                                  double high);

} // namespace sandbox::reference

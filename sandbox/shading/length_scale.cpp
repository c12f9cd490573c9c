#include "shading/length_scale.h"

#include "scene/space.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace sandbox {
namespace {

constexpr double smallest = 1e-16; ///< its square is 1e-32: far from float32's 1e-38
constexpr double largest = 1e16;

} // namespace

double length_scale(const Scene &scene, const Object &object, const Mesh &mesh) {
    const glm::dmat3 linear = linear_part(object.transform);
    const glm::dvec3 half = glm::max(glm::abs(mesh.bounds.low), glm::abs(mesh.bounds.high));
    const double reach = glm::length(object.transform.translate - scene.camera.position) +
                         half.x * glm::length(linear[0]) + half.y * glm::length(linear[1]) +
                         half.z * glm::length(linear[2]);
    const double low = reach > 0 ? std::min(reach, scene.camera.near_plane) : scene.camera.near_plane;
    double high = std::max(reach, scene.camera.near_plane);
    for (const Light &light : scene.lights) {
        if (light.type != LightType::directional) {
            high = std::max(high, glm::length(light.position - scene.camera.position));
        }
    }
    if (low >= smallest && high <= largest) {
        return 1;
    }
    return std::exp2(-std::nearbyint(0.5 * (std::log2(low) + std::log2(high))));
}

bool is_wide(const Scene &scene, const Object &object, const Mesh &mesh) {
    const glm::dmat3 linear = linear_part(object.transform);
    const glm::dvec3 half = 0.5 * (mesh.bounds.high - mesh.bounds.low);
    const double radius =
        half.x * glm::length(linear[0]) + half.y * glm::length(linear[1]) + half.z * glm::length(linear[2]);
    const glm::dvec3 center = linear * (0.5 * (mesh.bounds.low + mesh.bounds.high)) + object.transform.translate;
    const double distance = glm::length(center - scene.camera.position) - radius;
    return radius > 1e4 * std::max(distance, scene.camera.near_plane);
}

bool is_deep(const Camera &camera) { return camera.far_plane >= deep_range * camera.near_plane; }

} // namespace sandbox

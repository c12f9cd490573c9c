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

/// No vertex is farther from the eye than that.
double reach_of(const Camera &camera, const Object &object, const Mesh &mesh) {
    const Bounds &bounds = mesh.bounds;
    const glm::dvec3 middle = linear_part(object.transform) * (0.5 * (bounds.low + bounds.high));
    const glm::dvec3 half = 0.5 * (bounds.high - bounds.low) * glm::abs(object.transform.scale);
    return glm::length(middle + (object.transform.translate - camera.position)) + half.x + half.y + half.z;
}

} // namespace

double length_scale(const Scene &scene, const Object &object, const Mesh &mesh) {
    const double reach = reach_of(scene.camera, object, mesh);
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

bool is_deep(const Scene &scene, const std::vector<ObjectResources> &resources) {
    const Camera &camera = scene.camera;
    bool deep = is_deep(camera);
    for (std::size_t i = 0; i < scene.objects.size() && !deep; ++i) {
        deep = reach_of(camera, scene.objects[i], *resources[i].mesh) >= deep_range * camera.near_plane;
    }
    return deep;
}

bool is_deep(const Camera &camera) { return camera.far_plane >= deep_range * camera.near_plane; }

} // namespace sandbox

#include "shading/light_place.h"

#include "scene/light_kind.h"
#include "scene/space.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/matrix.hpp>
#include <limits>

namespace sandbox {
namespace {

/// Could a point of the object lie on the line `from` + t `along`, 0 <= t <= `most`, or seem to in float32? Against the
/// mesh's bounds, in object space, with some room.
bool may_cross(const Object &object, const Mesh &mesh, const glm::dvec3 &from, const glm::dvec3 &along, double most) {
    const glm::dmat3 linear = linear_part(object.transform);
    if (std::abs(glm::determinant(linear)) == 0) {
        return true;
    }
    const Bounds &bounds = mesh.bounds;
    const glm::dvec3 extent = bounds.high - bounds.low;
    const glm::dmat3 to_object = glm::inverse(linear);
    const glm::dvec3 start = to_object * (from - object.transform.translate);
    const glm::dvec3 step = to_object * along;
    const glm::dvec3 middle = linear * ((bounds.low + bounds.high) / 2.0) + object.transform.translate;
    const double distance = glm::length(from - middle) + (std::isfinite(most) ? most * glm::length(along) : 0);
    glm::dvec3 room = 0.01 * extent + glm::dvec3(1e-3 * glm::length(extent)); // flat shapes have some too
    for (int axis = 0; axis < 3; ++axis) {
        constexpr double angle = 1e-6; // below it float32's unit vectors are the same
        room[axis] += angle * distance * glm::length(glm::dvec3(glm::row(to_object, axis)));
    }
    double enters = 0, leaves = most;
    for (int axis = 0; axis < 3; ++axis) {
        const double low = bounds.low[axis] - room[axis] - start[axis];
        const double high = bounds.high[axis] + room[axis] - start[axis];
        if (step[axis] == 0) {
            if (low > 0 || high < 0) {
                return false;
            }
            continue;
        }
        const auto [first, last] = std::minmax({low / step[axis], high / step[axis]});
        enters = std::max(enters, first);
        leaves = std::min(leaves, last);
    }
    return !(enters > leaves); // bounds that are not finite cross
}

} // namespace

bool may_touch(const Light &light, const Object &object, const Mesh &mesh) {
    return may_cross(object, mesh, light.position, glm::dvec3(0), 0);
}

bool may_oppose(const Light &light, const Scene &scene, const Technique &technique, const Object &object,
                const Mesh &mesh) {
    const CameraAxes axes = camera_axes(scene.camera);
    constexpr double everywhere = std::numeric_limits<double>::infinity();
    if (technique.position != LightingPosition::world) {
        return true;
    }
    if (technique.viewer == Viewer::infinite) { // no H of its own for a directional light
        return !has_position(light) || may_cross(object, mesh, light.position, -axes.forward, everywhere);
    }
    return has_position(light)
               ? may_cross(object, mesh, scene.camera.position, light.position - scene.camera.position, 1)
               : may_cross(object, mesh, scene.camera.position, -light.direction, everywhere);
}

} // namespace sandbox

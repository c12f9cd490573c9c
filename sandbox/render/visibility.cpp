#include "render/visibility.h"

#include "scene/space.h"

#include <glad/gl.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace sandbox {
namespace {

/// How far the near plane's corners are from the eye.
double near_corner_distance(const Camera &camera, double aspect) {
    const double half_height = std::tan(glm::radians(camera.fov_y_degrees) / 2);
    return camera.near_plane * std::sqrt(1 + half_height * half_height * (1 + aspect * aspect));
}

/// A sphere around the transformed mesh.
struct BoundingSphere {
    glm::dvec3 center;
    double radius;
};
BoundingSphere bounding_sphere(const Object &object, const Mesh &mesh) {
    const Bounds &bounds = mesh.bounds;
    const glm::dmat3 linear = linear_part(object.transform);
    const glm::dvec3 half = 0.5 * (bounds.high - bounds.low);
    const double stretch =
        std::max({glm::length(linear[0]), glm::length(linear[1]), glm::length(linear[2])}); // linear = R S
    return {linear * (0.5 * (bounds.low + bounds.high)) + object.transform.translate, stretch * glm::length(half)};
}

} // namespace

bool back_faces_hidden(const Camera &camera, const Object &object, const Mesh &mesh, double aspect) {
    const glm::dvec3 &scale = object.transform.scale;
    if (!mesh.closed || scale.x == 0 || scale.y == 0 || scale.z == 0) {
        return false;
    }
    const BoundingSphere sphere = bounding_sphere(object, mesh);
    const double distance = glm::length(sphere.center - camera.position) - sphere.radius;
    return distance > near_corner_distance(camera, aspect);
}

void set_culling(const Camera &camera, const Object &object, const Mesh &mesh, double aspect) {
    const bool mirrored = glm::determinant(linear_part(object.transform)) < 0;
    glFrontFace(mirrored ? GL_CW : GL_CCW);
    (back_faces_hidden(camera, object, mesh, aspect) ? glEnable : glDisable)(GL_CULL_FACE);
}

} // namespace sandbox

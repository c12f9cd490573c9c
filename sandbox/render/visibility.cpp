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

} // namespace

bool back_faces_hidden(const Camera &camera, const Object &object, const Mesh &mesh, double aspect) {
    const glm::dvec3 &scale = object.transform.scale;
    if (!mesh.closed || scale.x == 0 || scale.y == 0 || scale.z == 0) {
        return false;
    }
    return distance_to_bounds(object.transform, mesh.bounds, camera.position) > near_corner_distance(camera, aspect);
}

void set_culling(const Camera &camera, const Object &object, const Mesh &mesh, double aspect) {
    const bool mirrored = glm::determinant(linear_part(object.transform)) < 0;
    glFrontFace(mirrored ? GL_CW : GL_CCW);
    (back_faces_hidden(camera, object, mesh, aspect) ? glEnable : glDisable)(GL_CULL_FACE);
}

} // namespace sandbox

#include "scene/space.h"

#include "scene/unit.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>
#include <utility>

namespace sandbox {
namespace {

/// Sine and cosine of an angle in degrees, exact at multiples of 90 (a quarter turn leaves no 1e-17 behind).
std::pair<double, double> sine_cosine(double degrees) {
    const double turn = std::remainder(degrees, 360.0);
    const double quarters = std::nearbyint(turn / 90);
    const double rest = (turn - quarters * 90) * (std::numbers::pi / 180);
    const double s = std::sin(rest);
    const double c = std::cos(rest);
    switch (static_cast<int>(quarters)) {
    case 0:
        return {s, c};
    case 1:
        return {c, -s};
    case -1:
        return {-c, s};
    default:
        return {-s, -c};
    }
}

/// Along the camera's axis, of any corner of the box around the transformed mesh.
double least_depth(const Camera &camera, const Transform &transform, const Bounds &bounds) {
    const glm::dmat3 linear = linear_part(transform);
    const glm::dvec3 forward = camera_axes(camera).forward;
    const glm::dvec3 half = 0.5 * (bounds.high - bounds.low);
    const glm::dvec3 middle = linear * (0.5 * (bounds.low + bounds.high)) + (transform.translate - camera.position);
    return glm::dot(forward, middle) - glm::dot(glm::abs(forward * linear), half);
}

} // namespace

double distance_to_bounds(const Transform &transform, const Bounds &bounds, const glm::dvec3 &point) {
    const glm::dmat3 turn = linear_part({{}, transform.rotate_degrees, glm::dvec3(1)});
    const glm::dvec3 local = glm::transpose(turn) * (point - transform.translate);
    const glm::dvec3 low = transform.scale * bounds.low; // above `high` where the scale is below 0
    const glm::dvec3 high = transform.scale * bounds.high;
    const glm::dvec3 beyond = glm::max(glm::min(low, high) - local, local - glm::max(low, high));
    return glm::length(glm::max(beyond, glm::dvec3(0)));
}

bool is_mirrored(const Transform &transform) {
    const glm::dvec3 &scale = transform.scale;
    const bool flattened = scale.x == 0 || scale.y == 0 || scale.z == 0;
    return !flattened && ((scale.x < 0) != (scale.y < 0)) != (scale.z < 0);
}

bool back_faces_hidden(const Camera &camera, double aspect, const Transform &transform, const Mesh &mesh) {
    const glm::dvec3 &scale = transform.scale;
    if (!mesh.closed || scale.x == 0 || scale.y == 0 || scale.z == 0) {
        return false;
    }
    if (is_orthographic(camera)) {
        return least_depth(camera, transform, mesh.bounds) > camera.near_plane;
    }
    const double half_height = std::tan(glm::radians(camera.fov_y_degrees / 2));
    const double near_corner = std::hypot(1, half_height, half_height * aspect) * camera.near_plane;
    return distance_to_bounds(transform, mesh.bounds, camera.position) > near_corner;
}

glm::dmat3 linear_part(const Transform &transform) {
    const auto [sx, cx] = sine_cosine(transform.rotate_degrees.x);
    const auto [sy, cy] = sine_cosine(transform.rotate_degrees.y);
    const auto [sz, cz] = sine_cosine(transform.rotate_degrees.z);
    // glm takes columns.
    const glm::dmat3 rx(1, 0, 0, 0, cx, sx, 0, -sx, cx);
    const glm::dmat3 ry(cy, 0, -sy, 0, 1, 0, sy, 0, cy);
    const glm::dmat3 rz(cz, sz, 0, -sz, cz, 0, 0, 0, 1);
    glm::dmat3 linear = rz * ry * rx;
    for (int axis = 0; axis < 3; ++axis) {
        linear[axis] *= transform.scale[axis];
    }
    return linear;
}

bool scales_evenly(const glm::dmat3 &linear) {
    const glm::dmat3 gram = glm::transpose(linear) * linear;
    const double scale = gram[0][0];
    double off = 0;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            off = std::max(off, std::abs(gram[i][j] - (i == j ? scale : 0)));
        }
    }
    return scale > 0 && off <= 1e-12 * scale;
}

bool up_is_along_view(const Camera &camera) {
    const glm::dvec3 side = glm::cross(unit(camera.target - camera.position), unit(camera.up));
    // 1e-9: an up this close to the view leaves fewer than half of a double's digits in the cross product; the picture
    // turns by 1e-16 / 1e-9 of a circle, which still moves no pixel, and by more from here on.
    return glm::dot(side, side) < 1e-18;
}

CameraAxes camera_axes(const Camera &camera) {
    const glm::dvec3 forward = unit(camera.target - camera.position);
    glm::dvec3 side = glm::cross(forward, unit(camera.up));
    if (up_is_along_view(camera)) {
        const glm::dvec3 another_up = std::abs(forward.z) < 0.9 ? glm::dvec3(0, 0, -1) : glm::dvec3(0, 1, 0);
        side = glm::cross(forward, another_up);
    }
    const glm::dvec3 right = unit(side);
    return {right, glm::cross(right, forward), forward};
}

glm::dmat3 world_to_view_axes(const Camera &camera) {
    const CameraAxes axes = camera_axes(camera);
    return glm::transpose(glm::dmat3(axes.right, axes.up, -axes.forward));
}

namespace {

glm::dmat4 orthographic_projection(const Camera &camera, const CameraAxes &axes, double aspect) {
    const double depth = camera.far_plane - camera.near_plane;
    const glm::dvec3 x = axes.right * (2 / (camera.height * aspect));
    const glm::dvec3 y = axes.up * (2 / camera.height);
    const glm::dvec3 z = axes.forward * (2 / depth);
    return {{x.x, y.x, z.x, 0},
            {x.y, y.y, z.y, 0},
            {x.z, y.z, z.z, 0},
            {0, 0, -(camera.far_plane + camera.near_plane) / depth, 1}};
}

glm::dmat4 perspective_projection(const Camera &camera, const CameraAxes &axes, double aspect) {
    const double focal = 1 / std::tan(camera.fov_y_degrees * (std::numbers::pi / 360));
    const double near = camera.near_plane;
    const double depth = camera.far_plane - near;
    const glm::dvec3 x = axes.right * (focal / aspect);
    const glm::dvec3 y = axes.up * focal;
    const glm::dvec3 z = axes.forward * ((camera.far_plane + near) / depth);
    const glm::dvec3 w = axes.forward;
    // Columns: what x, y, z and 1 of a position contribute to (clip x, y, z, w).
    return {{x.x, y.x, z.x, w.x},
            {x.y, y.y, z.y, w.y},
            {x.z, y.z, z.z, w.z},
            {0, 0, -2 * (camera.far_plane * near / depth), 0}};
}

} // namespace

glm::dmat4 view_projection(const Camera &camera, double aspect) {
    const CameraAxes axes = camera_axes(camera);
    glm::dmat4 clip = is_orthographic(camera) ? orthographic_projection(camera, axes, aspect)
                                              : perspective_projection(camera, axes, aspect);
    for (int i = 0; i < 4; ++i) {
        clip[i].x += camera.picture_shift.x * clip[i].w;
        clip[i].y += camera.picture_shift.y * clip[i].w;
    }
    return clip;
}

double view_height(const Camera &camera, double depth) {
    return is_orthographic(camera) ? camera.height : 2 * depth * std::tan(glm::radians(camera.fov_y_degrees) / 2);
}

double height_at_target(const Camera &camera) {
    return view_height(camera, glm::length(camera.position - camera.target));
}

std::optional<glm::dvec2> place_in_view(const Camera &camera, double aspect, const glm::dvec3 &from_eye) {
    const glm::dvec4 clip = view_projection(camera, aspect) * glm::dvec4(from_eye, 1);
    return clip.w > 0 ? std::optional(glm::dvec2(0.5 + clip.x / clip.w / 2, 0.5 - clip.y / clip.w / 2)) : std::nullopt;
}

} // namespace sandbox

#include "scene/orbit.h"

#include "scene/scene_format.h"
#include "scene/space.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

namespace sandbox {

namespace {

bool in_world(glm::dvec3 p) { return glm::all(glm::lessThanEqual(glm::abs(p), glm::dvec3(camera_coordinate.high))); }

/// Rodrigues' rotation of `v` about the unit `axis`, right-handed.
glm::dvec3 rotate_about(glm::dvec3 v, glm::dvec3 axis, double radians) {
    const double c = std::cos(radians);
    return v * c + glm::cross(axis, v) * std::sin(radians) + axis * (glm::dot(axis, v) * (1 - c));
}

/// An orthonormal frame with `up` as its axle; the two others depend on `up` alone, so that angles stay comparable.
struct Turntable {
    glm::dvec3 axle, zero, ninety;
};

Turntable turntable(const Camera &camera) {
    const double length = glm::length(camera.up);
    const glm::dvec3 axle = length > 0 ? camera.up / length : glm::dvec3(0, 1, 0);
    const glm::dvec3 helper = std::abs(axle.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
    const glm::dvec3 zero = glm::normalize(helper - axle * glm::dot(helper, axle));
    return {axle, zero, glm::cross(axle, zero)};
}

/// The horizontal way from target to camera; over a pole, where there is none, what the picture's own up says.
glm::dvec3 outward(const Camera &camera, const Turntable &table, glm::dvec3 offset, double height) {
    const glm::dvec3 level = offset - table.axle * height;
    if (glm::length(level) > 1e-9 * glm::length(offset)) {
        return level;
    }
    const glm::dvec3 picture_up = camera_axes(camera).up;
    return height > 0 ? -picture_up : picture_up;
}

double kept_between_planes(const Camera &camera, double distance) {
    const double low = camera.near_plane * 1.5;
    const double high = std::max(camera.far_plane * 0.95, low);
    return std::clamp(distance, low, high);
}

} // namespace

Camera orbit_camera(const Camera &camera, double degrees) {
    if (degrees == 0) {
        return camera;
    }
    Camera turned = camera;
    const glm::dvec3 axis = glm::normalize(camera.up);
    turned.position =
        camera.target + rotate_about(camera.position - camera.target, axis, degrees * std::numbers::pi / 180);
    return turned;
}

OrbitPose orbit_pose(const Camera &camera) {
    const glm::dvec3 offset = camera.position - camera.target;
    const double distance = glm::length(offset);
    if (!(distance > 0)) {
        return {0, 0, 0};
    }
    const Turntable table = turntable(camera);
    const double height = glm::dot(offset, table.axle);
    const glm::dvec3 level = outward(camera, table, offset, height);
    OrbitPose pose;
    pose.azimuth_degrees = glm::degrees(std::atan2(glm::dot(level, table.ninety), glm::dot(level, table.zero)));
    pose.elevation_degrees = glm::degrees(std::asin(std::clamp(height / distance, -1.0, 1.0)));
    pose.distance = distance;
    return pose;
}

Camera at_pose(Camera camera, OrbitPose pose) {
    const Turntable table = turntable(camera);
    const double azimuth = glm::radians(pose.azimuth_degrees);
    const double elevation = glm::radians(pose.elevation_degrees);
    const glm::dvec3 level = table.zero * std::cos(azimuth) + table.ninety * std::sin(azimuth);
    const glm::dvec3 outward = level * std::cos(elevation) + table.axle * std::sin(elevation);
    const glm::dvec3 position = camera.target + outward * kept_between_planes(camera, pose.distance);
    camera.position = in_world(position) ? position : camera.position;
    return camera;
}

Camera orbited(const Camera &camera, double azimuth_degrees, double elevation_degrees) {
    OrbitPose pose = orbit_pose(camera);
    if (!(pose.distance > 0)) {
        return camera;
    }
    const double low = std::min(-most_elevation_degrees, pose.elevation_degrees);
    const double high = std::max(most_elevation_degrees, pose.elevation_degrees);
    pose.azimuth_degrees += azimuth_degrees;
    pose.elevation_degrees = std::clamp(pose.elevation_degrees + elevation_degrees, low, high);
    return at_pose(camera, pose);
}

Camera dollied(const Camera &camera, double factor) {
    if (is_orthographic(camera) && factor > 0) {
        Camera changed = camera;
        changed.height = nearest_accepted(camera.height * factor, positive_length);
        return changed;
    }
    const glm::dvec3 offset = camera.position - camera.target;
    const double distance = glm::length(offset);
    if (!(distance > 0) || !(factor > 0)) {
        return camera;
    }
    Camera moved = camera;
    moved.position = camera.target + offset * (kept_between_planes(camera, distance * factor) / distance);
    return in_world(moved.position) ? moved : camera;
}

Camera with_projection(Camera camera, Projection projection) {
    if (camera.projection == projection) {
        return camera;
    }
    const double height = height_at_target(camera);
    const double distance = glm::length(camera.position - camera.target);
    camera.projection = projection;
    camera.height = is_orthographic(camera) ? nearest_accepted(height, positive_length) : 0;
    camera.fov_y_degrees = is_orthographic(camera)
                               ? Camera{}.fov_y_degrees
                               : nearest_accepted(glm::degrees(2 * std::atan2(0.5 * height, distance)), view_angle);
    return camera;
}

Camera panned(Camera camera, double right, double up) {
    const CameraAxes axes = camera_axes(camera);
    const glm::dvec3 step = (axes.right * right + axes.up * up) * height_at_target(camera);
    const bool inside = in_world(camera.position + step) && in_world(camera.target + step);
    if (inside) {
        camera.position += step;
        camera.target += step;
    }
    return camera;
}

} // namespace sandbox

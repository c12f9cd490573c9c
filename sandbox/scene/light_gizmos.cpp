#include "scene/light_gizmos.h"

#include "scene/light_kind.h"
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

/// The ball on which a light is turned, from the eye.
struct Ball {
    glm::dvec3 center;
    double radius;
};

/// About the lamp or, of a light from far away, about the camera's target: a share of what the view shows there, and
/// never as far as the eye.
Ball turning_ball(const Scene &scene, const Light &light, double aspect) {
    const Camera &camera = scene.camera;
    const glm::dvec3 center = (has_position(light) ? light.position : camera.target) - camera.position;
    const double depth = glm::dot(center, camera_axes(camera).forward);
    const double share = has_position(light) ? 0.25 : 0.4;
    const double radius = share * std::min(aspect, 1.0) * view_height(camera, depth);
    return {center, is_orthographic(camera) ? radius : std::min(radius, 0.6 * depth)};
}

/// From the ball's centre to the handle.
glm::dvec3 handle_direction(const Light &light) {
    return has_position(light) ? glm::normalize(light.direction) : -glm::normalize(light.direction);
}

bool in_picture(const glm::dvec2 &place) { return place.x >= 0 && place.x <= 1 && place.y >= 0 && place.y <= 1; }

/// On the ball, at this angle from the axis; nothing if a part is behind the eye.
std::vector<glm::dvec2> circle(const Camera &camera, double aspect, const Ball &ball, const glm::dvec3 &axis,
                               double degrees) {
    const glm::dvec3 helper = std::abs(axis.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    const glm::dvec3 u = glm::normalize(glm::cross(axis, helper)), v = glm::cross(axis, u);
    const double angle = glm::radians(degrees);
    constexpr int points = 64;
    std::vector<glm::dvec2> line;
    for (int i = 0; i <= points; ++i) {
        const double turn = 2 * std::numbers::pi * i / points;
        const glm::dvec3 side = u * std::cos(turn) + v * std::sin(turn);
        const auto place = place_in_view(camera, aspect,
                                         ball.center + ball.radius * (axis * std::cos(angle) + side * std::sin(angle)));
        if (!place) {
            return {};
        }
        line.push_back(*place);
    }
    return line;
}

/// From the lamp to the two points of a circle between which all others are seen; nothing from inside the cone.
std::vector<glm::dvec2> outline(const glm::dvec2 &lamp, const std::vector<glm::dvec2> &circle, double aspect) {
    const auto from_lamp = [&](const glm::dvec2 &p) { return (p - lamp) * glm::dvec2(aspect, 1); };
    glm::dvec2 middle(0);
    for (const glm::dvec2 &p : circle) {
        middle += from_lamp(p);
    }
    const auto angle = [&](const glm::dvec2 &p) {
        const glm::dvec2 q = from_lamp(p);
        return std::atan2(middle.x * q.y - middle.y * q.x, glm::dot(middle, q));
    };
    const auto [low, high] =
        std::ranges::minmax_element(circle, [&](const auto &a, const auto &b) { return angle(a) < angle(b); });
    if (circle.empty() || angle(*high) - angle(*low) >= std::numbers::pi) {
        return {};
    }
    return {*low, lamp, *high};
}

/// The point of the ball under a place, on the side of the ball where `handle` is; over the outline it changes sides.
glm::dvec3 on_ball(const Camera &camera, double aspect, const Ball &ball, const glm::dvec3 &handle,
                   const glm::dvec2 &place) {
    const CameraAxes axes = camera_axes(camera);
    const double half = view_height(camera, 1) / 2;
    const glm::dvec3 across = axes.right * ((2 * place.x - 1) * half * aspect) + axes.up * ((1 - 2 * place.y) * half);
    if (is_orthographic(camera)) {
        const glm::dvec3 offset = across - (ball.center - axes.forward * glm::dot(ball.center, axes.forward));
        const double far = glm::length(offset);
        const bool over = far > ball.radius;
        const double r = over ? std::max(2 * ball.radius - far, 0.0) : far;
        const double side = (glm::dot(handle, axes.forward) > 0) != over ? 1 : -1;
        const glm::dvec3 beside = far > 0 ? offset * (r / far) : glm::dvec3(0);
        return beside + axes.forward * (side * std::sqrt(std::max(ball.radius * ball.radius - r * r, 0.0)));
    }
    const double distance = glm::length(ball.center);
    const glm::dvec3 towards = ball.center / distance;
    const glm::dvec3 ray = glm::normalize(axes.forward + across);
    const glm::dvec3 away = ray - towards * glm::dot(ray, towards); // from the ball's middle, at right angles
    const double sine = glm::length(away);
    const double angle = std::atan2(sine, glm::dot(ray, towards));
    const double outline = std::asin(std::min(ball.radius / distance, 1.0));
    const bool over = angle > outline;
    const double a = over ? std::max(2 * outline - angle, 0.0) : angle;
    const bool is_far = glm::dot(ball.center + ball.radius * handle, handle) > 0;
    const double side = is_far != over ? 1 : -1;
    const double beside = distance * std::sin(a);
    const double along =
        distance * std::cos(a) + side * std::sqrt(std::max(ball.radius * ball.radius - beside * beside, 0.0));
    const glm::dvec3 turned = towards * std::cos(a) + (sine > 0 ? away / sine : glm::dvec3(0)) * std::sin(a);
    return turned * along - ball.center;
}

Light turned_light(const Scene &scene, const Light &light, double aspect, const glm::dvec2 &by) {
    const Ball ball = turning_ball(scene, light, aspect);
    const glm::dvec3 handle = handle_direction(light);
    const auto place = place_in_view(scene.camera, aspect, ball.center + ball.radius * handle);
    Light turned = light;
    if (place && ball.radius > 0) {
        const glm::dvec3 to = glm::normalize(on_ball(scene.camera, aspect, ball, handle, *place + by));
        turned.direction = (has_position(light) ? to : -to) * glm::length(light.direction);
    }
    return turned;
}

} // namespace

std::vector<LightGizmo> light_gizmos(const Scene &scene, double aspect) {
    const Camera &camera = scene.camera;
    std::vector<LightGizmo> gizmos;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const Light &light = scene.lights[i];
        const Ball ball = turning_ball(scene, light, aspect);
        const auto at = [&](double share) {
            return place_in_view(camera, aspect, ball.center + handle_direction(light) * (share * ball.radius));
        };
        const auto lamp = at(has_position(light) ? 0 : 1);
        if (!light.enabled || !(ball.radius > 0) || !lamp || !in_picture(*lamp)) {
            continue;
        }
        LightGizmo gizmo{i, *lamp, {}, {}, false, {}};
        if (uses_direction(light)) {
            constexpr double head = 0.4; // before the target
            gizmo.from = lamp;
            gizmo.to = at(has_position(light) ? 1 : head);
            gizmo.turns = has_position(light);
        }
        if (has_cone(light)) {
            const glm::dvec3 axis = handle_direction(light);
            gizmo.lines.push_back(circle(camera, aspect, ball, axis, light.cutoff_degrees));
            gizmo.lines.push_back(outline(*lamp, gizmo.lines.front(), aspect));
            if (light.inner_cutoff_degrees < light.cutoff_degrees) {
                gizmo.lines.push_back(circle(camera, aspect, ball, axis, light.inner_cutoff_degrees));
            }
        }
        gizmos.push_back(gizmo);
    }
    return gizmos;
}

Light dragged_light(const Scene &scene, std::size_t light, LightHandle handle, double aspect, const glm::dvec2 &by) {
    Light dragged = scene.lights.at(light);
    if (by == glm::dvec2(0)) {
        return dragged;
    }
    if (handle == LightHandle::tip || !has_position(dragged)) {
        return turned_light(scene, dragged, aspect, by);
    }
    const CameraAxes axes = camera_axes(scene.camera);
    const double height = view_height(scene.camera, glm::dot(dragged.position - scene.camera.position, axes.forward));
    const glm::dvec3 position = dragged.position + axes.right * (by.x * height * aspect) - axes.up * (by.y * height);
    const bool in_world = glm::all(glm::lessThanEqual(glm::abs(position), glm::dvec3(coordinate.high)));
    dragged.position = in_world ? position : dragged.position;
    return dragged;
}

} // namespace sandbox

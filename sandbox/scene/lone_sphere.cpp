#include "scene/lone_sphere.h"

#include "image/error.h"
#include "scene/light_kind.h"
#include "scene/space.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace sandbox {
namespace {

constexpr int rings = 64, segments = 2 * rings;
constexpr double filled = 0.88;         ///< of the picture's height, by the sphere
constexpr double most_of_the_way = 0.5; ///< of the distance to the nearest lamp or to the eye, for a sphere's radius

bool is_round(const Object &object) {
    return std::holds_alternative<SphereShape>(object.mesh) && scales_evenly(linear_part(object.transform));
}

struct Ball {
    glm::dvec3 center;
    double radius;
};

Ball ball_of(const Object &sphere) {
    const double scale = glm::length(linear_part(sphere.transform)[0]);
    return {sphere.transform.translate, std::get<SphereShape>(sphere.mesh).radius * scale};
}

/// Half as wide as the box around the object is in the middle one of its extents, and clear of lamps and the eye.
Ball ball_in_place_of(const Scene &scene, const Object &object, const Bounds &bounds) {
    const glm::dmat3 linear = linear_part(object.transform);
    const glm::dvec3 half = (bounds.high - bounds.low) / 2.0;
    std::array<double, 3> extents{};
    for (int axis = 0; axis < 3; ++axis) {
        extents[static_cast<std::size_t>(axis)] = std::abs(linear[0][axis]) * half.x +
                                                  std::abs(linear[1][axis]) * half.y +
                                                  std::abs(linear[2][axis]) * half.z;
    }
    std::ranges::sort(extents);
    const glm::dvec3 center = object.transform.translate + linear * ((bounds.low + bounds.high) / 2.0);
    double radius = extents[1] > 0 ? extents[1] : 1;
    const auto keep_clear_of = [&](const glm::dvec3 &point) {
        const double distance = glm::distance(point, center);
        radius = distance > 0 ? std::min(radius, most_of_the_way * distance) : radius;
    };
    for (const Light &light : scene.lights) {
        if (light.enabled && kind_of(light.type).positional) {
            keep_clear_of(light.position);
        }
    }
    keep_clear_of(scene.camera.position);
    return {center, radius};
}

Camera camera_at(Camera camera, const Ball &ball) {
    double distance = glm::distance(camera.position, ball.center);
    if (distance <= ball.radius || is_orthographic(camera)) { // V is the same wherever an orthographic eye stands
        distance = std::max(distance, 2 * ball.radius);
        camera.position = ball.center - camera_axes(camera).forward * distance;
    }
    camera.target = ball.center;
    if (is_orthographic(camera)) {
        camera.height = 2 * ball.radius / filled;
    } else {
        const double tangent = std::tan(std::asin(ball.radius / distance)) / filled;
        camera.fov_y_degrees = glm::degrees(2 * std::atan(tangent));
    }
    camera.near_plane = std::min(camera.near_plane, (distance - ball.radius) / 2);
    camera.far_plane = std::max(camera.far_plane, distance + ball.radius);
    return camera;
}

bool has_highlights(const Scene &scene) {
    return scene.objects.front().material.specular != glm::dvec3(0) &&
           std::ranges::any_of(scene.lights, [](const Light &light) {
               return light.enabled && light.specular > 0 && light.color != glm::dvec3(0);
           });
}

} // namespace

LoneSphere lone_sphere(const Scene &scene, const std::vector<ObjectResources> &resources) {
    if (scene.objects.empty()) {
        throw InputError("objects: expected at least one object");
    }
    const auto found = std::ranges::find_if(scene.objects, is_round);
    LoneSphere sphere;
    sphere.own = found != scene.objects.end();
    Object object = sphere.own ? *found : scene.objects.front();
    const Ball ball = sphere.own ? ball_of(object) : ball_in_place_of(scene, object, resources.front().mesh->bounds);
    sphere.of = object.name;
    if (sphere.own) {
        auto &shape = std::get<SphereShape>(object.mesh);
        shape.rings = rings;
        shape.segments = segments;
    } else {
        object.mesh = SphereShape{ball.radius, rings, segments};
        object.transform = {.translate = ball.center};
    }
    sphere.scene = scene;
    sphere.scene.objects = {object};
    sphere.scene.views.clear();
    sphere.scene.camera = camera_at(scene.camera, ball);
    sphere.made_shiny = !has_highlights(sphere.scene);
    if (sphere.made_shiny) {
        sphere.scene.objects.front().material.specular = glm::dvec3(0.5);
        for (Light &light : sphere.scene.lights) {
            light.specular = 1;
        }
    }
    return sphere;
}

} // namespace sandbox

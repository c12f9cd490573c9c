#include "tools/masks/owed.h"

#include "reference/branches.h"
#include "reference/raster.h"
#include "scene/light_kind.h"
#include "scene/space.h"
#include "tools/conditioning.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <memory>
#include <numbers>

namespace sandbox {
namespace {

constexpr double step = 2 * reference::rounding; ///< those of normals and of positions together
constexpr int many_ways = 400;                   ///< 10 degrees apart

/// The picture moves by `right` and `down` pixels; nothing is lit otherwise but what V of an orthographic camera is.
Scene turned(Scene scene, Size size, double right, double down) {
    Camera &camera = scene.camera;
    const CameraAxes axes = camera_axes(camera);
    const double distance = glm::length(camera.target - camera.position);
    const double height =
        is_orthographic(camera) ? camera.height : 2 * distance * std::tan(glm::radians(camera.fov_y_degrees) / 2);
    const glm::dvec3 by = height / size.height * (down * axes.up - right * axes.right);
    camera.target += by;
    camera.position += is_orthographic(camera) ? by : glm::dvec3(0);
    return scene;
}

/// Lights against objects, by a rounding of how far they reach: what a difference of two positions may lose.
Scene pulled_apart(Scene scene, const std::vector<ObjectResources> &resources, const glm::dvec3 &by) {
    const glm::dvec3 eye = scene.camera.position;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        Object &object = scene.objects[i];
        object.transform.translate += by * reach_from(eye, object, *resources[i].mesh);
    }
    for (Light &light : scene.lights) {
        light.position -= by * glm::length(light.position - eye);
    }
    return scene;
}

/// To and fro along their own axes, as far as that: where a light stands on a surface, these are the directions that
/// its cone lets through.
Scene along_their_axes(Scene scene, double by) {
    for (Light &light : scene.lights) {
        light.position += by * glm::length(light.position - scene.camera.position) * glm::normalize(light.direction);
    }
    return scene;
}

/// The i-th of `count` directions, evenly spread: a narrow cone or a highlight lets few of them through.
glm::dvec3 spread_over_a_ball(int i, int count) {
    const double y = 1 - (2 * i + 1.0) / count;
    const double turn = i * std::numbers::pi * (3 - std::sqrt(5.0)); // by the golden ratio
    const double r = std::sqrt(1 - y * y);
    return {r * std::cos(turn), y, r * std::sin(turn)};
}

Scene other_directions(Scene scene, const glm::dvec3 &by) {
    for (Light &light : scene.lights) {
        light.direction += by * glm::length(light.direction);
    }
    return scene;
}

/// By four roundings of a direction: cones narrower than that are met by chance alone.
Scene wider_cones(Scene scene) {
    for (Light &light : scene.lights) {
        if (has_cone(light)) {
            const bool hard = light.inner_cutoff_degrees == light.cutoff_degrees;
            light.cutoff_degrees = std::min(light.cutoff_degrees + glm::degrees(2 * step), 90.0);
            light.inner_cutoff_degrees = hard ? light.cutoff_degrees : light.inner_cutoff_degrees;
        }
    }
    return scene;
}

std::vector<ObjectResources> other_normals(std::vector<ObjectResources> resources, const glm::dvec3 &by) {
    for (ObjectResources &one : resources) {
        Mesh mesh = *one.mesh;
        for (glm::dvec3 &normal : mesh.normals) {
            normal += by * glm::length(normal);
        }
        one.mesh = std::make_shared<const Mesh>(std::move(mesh));
    }
    return resources;
}

} // namespace

std::vector<bool> owed_pixels(const Scene &placed, const std::vector<ObjectResources> &resources,
                              const Technique &technique, const ReferenceFrame &truth, double negligible,
                              const std::vector<bool> &asked, std::size_t few) {
    std::vector<bool> owed(truth.color.size(), false);
    const auto unproved = [&] {
        std::size_t count = 0;
        for (std::size_t i = 0; i < owed.size(); ++i) {
            count += asked[i] && !owed[i] ? 1U : 0U;
        }
        return count;
    };
    const auto note = [&](const Scene &scene, const std::vector<ObjectResources> &meshes) {
        const ReferenceFrame moved = render_reference(scene, meshes, technique, truth.size);
        for (std::size_t i = 0; i < owed.size(); ++i) {
            const glm::dvec3 change = glm::abs(moved.color[i] - truth.color[i]);
            const bool differs = !(std::max({change.x, change.y, change.z}) <= negligible);
            owed[i] = owed[i] || differs || moved.object_ids[i] != truth.object_ids[i];
        }
    };
    const Scene scene = reads_the_origin(technique) ? placed : seen_from_the_origin(placed);
    note(wider_cones(scene), resources);
    for (const double sign : {-1.0, 1.0}) {
        note(turned(scene, truth.size, reference::edge_width, sign * reference::edge_width), resources);
        note(turned(scene, truth.size, -reference::edge_width, sign * reference::edge_width), resources);
        note(along_their_axes(scene, sign * step), resources);
        for (int corner = 0; corner < 4; ++corner) {
            const glm::dvec3 way(1, corner % 2 == 0 ? 1 : -1, corner < 2 ? 1 : -1);
            note(pulled_apart(scene, resources, sign * step * way), resources);
        }
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 by(0);
            by[axis] = sign * step;
            note(pulled_apart(scene, resources, by), resources);
            note(other_directions(scene, by), resources);
            note(scene, other_normals(resources, by));
        }
    }
    for (int i = 0; i < many_ways && unproved() > few; ++i) { // two cells of a checker may change, and the colour not
        const glm::dvec3 by = reference::edge_width * spread_over_a_ball(i, many_ways);
        note(turned(scene, truth.size, by.x, by.z), resources);
    }
    for (int i = 0; i < many_ways && unproved() > few; ++i) {
        note(pulled_apart(scene, resources, step * spread_over_a_ball(i, many_ways)), resources);
    }
    return owed;
}

} // namespace sandbox

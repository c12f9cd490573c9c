#include "ui/session/edits.h"

#include "scene/light_kind.h"
#include "scene/scene_format.h"
#include "scene/space.h"
#include "scene/unit.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

namespace sandbox {

namespace {

constexpr std::size_t most_lights = 64;
constexpr glm::dvec3 down(0, -1, 0);

/// A camera may stand farther out than a light.
glm::dvec3 in_world(glm::dvec3 position) { return glm::clamp(position, coordinate.low, coordinate.high); }

double reach(const Camera &camera) { return std::max(glm::length(camera.position - camera.target), 1e-3); }

} // namespace

std::size_t count_lights(const Scene &scene, LightType type) {
    return static_cast<std::size_t>(std::ranges::count(scene.lights, type, &Light::type));
}

bool can_add_light(const Scene &scene, LightType type) {
    return scene.lights.size() < most_lights && count_lights(scene, type) < most_lights_of_a_type;
}

void add_light(Scene &scene, LightType type) {
    if (!can_add_light(scene, type)) {
        return;
    }
    const CameraAxes axes = camera_axes(scene.camera);
    Light light;
    light.type = type;
    const glm::dvec3 shoulder = 0.35 * axes.right + 0.45 * axes.up - 0.5 * axes.forward;
    light.position = in_world(scene.camera.target + shoulder * reach(scene.camera));
    light.direction = unit_or(-shoulder, down);
    scene.lights.push_back(light);
}

void switch_lights(Scene &scene, LightType type, bool on) {
    if (on && count_lights(scene, type) == 0) {
        add_light(scene, type);
        return;
    }
    for (Light &light : scene.lights) {
        if (light.type == type) {
            light.enabled = on;
        }
    }
}

void set_type(Light &light, LightType type, const Camera &camera) {
    if (light.type == type) {
        return;
    }
    const Light untouched;
    if (kind_of(type).positional && light.position == untouched.position) {
        light.position = in_world(camera.target - unit_or(light.direction, down) * (0.6 * reach(camera)));
    }
    if (kind_of(type).directed && light.direction == untouched.direction) {
        light.direction = unit_or(camera.target - light.position, down);
    }
    light.type = type;
}

void set_cutoff(Light &light, double degrees) {
    const bool hard_edge = light.inner_cutoff_degrees == light.cutoff_degrees;
    light.cutoff_degrees = degrees == 180 ? 180 : std::clamp(degrees, 0.0, 90.0);
    light.inner_cutoff_degrees =
        hard_edge ? light.cutoff_degrees : std::min(light.inner_cutoff_degrees, light.cutoff_degrees);
}

void keep_attenuation_valid(Attenuation &attenuation) {
    if (attenuation.constant == 0 && attenuation.linear == 0 && attenuation.quadratic == 0) {
        attenuation.constant = 0.001;
    }
}

void keep_valid(Light &light, const Light &before) {
    if (light.direction == glm::dvec3(0)) {
        light.direction = before.direction;
    }
    if (const double cutoff = std::exchange(light.cutoff_degrees, before.cutoff_degrees);
        cutoff != before.cutoff_degrees) {
        set_cutoff(light, cutoff);
    }
    light.inner_cutoff_degrees = std::min(light.inner_cutoff_degrees, light.cutoff_degrees);
    keep_attenuation_valid(light.attenuation);
}

void set_key(Technique &technique, const TechniqueKey &key, int value) {
    key.set(technique, value);
    technique.own = technique.model == Model::own ? technique.own : OwnShader();
    technique = nearest_valid(technique);
}

void reset_camera(Document &document) { document.scene.camera = document.opened->scene.camera; }

} // namespace sandbox

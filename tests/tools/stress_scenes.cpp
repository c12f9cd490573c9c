#include "tools/stress_scenes.h"

#include "scene/orbit.h"
#include "scene/space.h"
#include "tools/stress_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <string>
#include <string_view>

namespace sandbox {
namespace {

/// What the programs of a family hold besides what its technique does.
struct Family {
    std::string_view lights; ///< kinds as stress::any_light takes them
    std::string_view terms;  ///< a: ambient, d: diffuse, s: specular; without them the term is 0
    bool two_sided = false;
    bool checker = false;
    bool emission = false;
    bool orthographic = false;
    bool open = false; ///< an open, textured surface, every other one seen through a telescope
};
constexpr std::array<Family, stress_families> families{{
    {"d", "ads", false, false, false},
    {"p", "ads", false, false, false},
    {"a", "ads", false, false, false},
    {"h", "ads", false, false, false},
    {"s", "ads", false, false, false},
    {"q", "ads", true, false, false},
    {"l", "ds", false, false, true},
    {"k", "ds", true, false, false},
    {"p", "s", false, false, false},
    {"a", "d", true, false, false},
    {"dp", "ads", true, false, false},
    {"dh", "ds", false, true, false},
    {"as", "ads", true, false, true},
    {"pq", "ds", false, true, true},
    {"hs", "s", true, false, false},
    {"das", "ads", false, true, false},
    {"ddp", "ads", true, true, false},
    {"dpahs", "ads", false, false, false},
    {"aaaaaaaaaaaa", "ads", false, false, false},
    {"dahsdahsdahsdahsdahsdahsdahsdahsdahsdahsdahsdahsdahsdahsdahsdahs", "ads", false, false, false}, // 64
    {"dp", "ads", false, false, false, true},
    {"hs", "ads", true, true, true, true},
    {"pd", "ads", true, false, false, false, true},
    {"as", "ads", true, false, false, true, true},
    {"k", "ds", true, false, true, false, true},
}};

constexpr double farthest = 1e9; ///< a coordinate

constexpr std::array<std::string_view, 17> techniques{
    "per-pixel/blinn-phong",
    "per-vertex/phong",
    "flat/blinn-phong",
    "per-pixel/phong",
    "interpolated-vectors/blinn-phong",
    "hybrid/phong",
    "per-pixel/blinn-phong:program=full",
    "per-vertex/blinn-phong",
    "per-pixel/lambert",
    "interpolated-vectors/phong",
    "hybrid/blinn-phong",
    "per-pixel/phong:power=stable",
    "flat/phong",
    "per-vertex/phong:program=full",
    "interpolated-vectors/blinn-phong:program=full",
    "hybrid/blinn-phong:program=full",
    "flat/phong:program=full",
};

/// The third light is the last that interpolated-vectors carries in all of the families.
std::vector<Technique> techniques_of(std::uint32_t family) {
    std::vector<Technique> out;
    for (std::uint32_t i = 0; out.size() < stress_techniques; ++i) {
        const Technique technique = parse_technique(techniques[(stress_techniques * family + i) % techniques.size()]);
        if (families[family].lights.size() <= 3 || technique.frequency != Frequency::interpolated_vectors) {
            out.push_back(technique);
        }
    }
    return out;
}

Camera any_camera(StressDice &dice, double unit, double telescopes) {
    Camera camera;
    double distance = unit * (dice.chance(0.1) ? dice.power_of_ten(-3, 2) : dice.power_of_ten(0.3, 1));
    if (dice.chance(telescopes)) { // through a telescope of 5e-4 to 2e-2 degrees
        distance = std::min(unit * dice.power_of_ten(4, 5.5), farthest);
    }
    camera.position = dice.direction() * distance;
    camera.up = dice.direction() * dice.power_of_ten(-8, 8);
    camera.fov_y_degrees = std::min(glm::degrees(2 * std::atan(1.5 * unit / distance)), 120.0);
    camera.near_plane = distance * dice.power_of_ten(-4, -1);
    camera.far_plane = distance * dice.power_of_ten(1, 4);
    if (dice.chance(0.1)) {
        camera.fov_y_degrees = dice.one_of({0.1, 1.0, 150.0, 179.0}); // float32 clips by 1e-3 degrees no more
    }
    if (dice.chance(0.1)) {
        camera.near_plane = std::max(distance * 1e-9, 1e-30);
        camera.far_plane = std::max(1e15, 2 * camera.near_plane);
    }
    return camera;
}

/// The camera goes so near to where the first light is mirrored that a stiff highlight fills the picture.
void zoom_on_highlight(Scene &scene, StressDice &dice, double unit) {
    Object &object = scene.objects[0];
    object.mesh = SphereShape{1, 16, 24};
    object.transform.translate = {};
    object.transform.scale = glm::dvec3(unit);
    const double width = 1 / std::sqrt(std::max(object.material.shininess, 1.0));
    const double distance = unit * dice.power_of_ten(0.3, 1);
    const glm::dvec3 way = dice.direction();
    scene.camera = {way * distance, {}, dice.direction(), 0, 0.01 * distance, 10 * distance};
    scene.camera.fov_y_degrees =
        std::min(glm::degrees(2 * std::atan(1.5 * unit / distance)), 120.0) * std::min(3 * width, 1.0);
    const glm::dvec3 beside = glm::normalize(way + width * dice.direction());
    Light &light = scene.lights[0];
    light.position = beside * std::max(glm::length(light.position), 1.5 * unit);
    light.direction = -beside;
    light.specular = 1;
    light.diffuse *= light.diffuse == 0 ? 1 : 0.01 / light.diffuse;
    light.ambient *= light.ambient == 0 ? 1 : 0.01 / light.ambient;
}

/// Where the first light, or the eye, is in trouble: the light in the eye, on the surface; the eye above the surface.
void set_trap(Scene &scene, StressDice &dice, const glm::dvec3 &top) {
    glm::dvec3 &eye = scene.camera.position;
    glm::dvec3 &light = scene.lights[0].position;
    switch (dice.below(3)) {
    case 0:
        light = eye;
        break;
    case 1:
        light = top;
        break;
    default:
        eye = top * (1 + dice.power_of_ten(-6, -1));
        scene.camera.near_plane = glm::length(eye - top) * dice.power_of_ten(-6, -1);
        scene.camera.far_plane = std::max(scene.camera.far_plane, 2 * scene.camera.near_plane);
        break;
    }
}

void move_everything(Scene &scene, const glm::dvec3 &by) {
    scene.camera.position += by;
    scene.camera.target += by;
    for (Object &object : scene.objects) {
        object.transform.translate += by;
    }
    for (Light &light : scene.lights) {
        light.position += by;
    }
}

void keep_terms(Light &light, std::string_view terms) {
    light.ambient *= terms.find('a') == std::string_view::npos ? 0 : 1;
    light.diffuse *= terms.find('d') == std::string_view::npos ? 0 : 1;
    light.specular *= terms.find('s') == std::string_view::npos ? 0 : 1;
}

struct PlacedObject {
    Object object;
    glm::dvec3 top; ///< the end of its y axis, which is a vertex of most shapes
};

/// About `unit` in size, whatever the size of its mesh.
PlacedObject any_object(StressDice &dice, const Family &family, double unit) {
    const stress::StressShape shape = family.open ? stress::open_shape(dice) : stress::any_shape(dice);
    Object object{"object", shape.shape, {}, {}, family.two_sided};
    Transform &transform = object.transform;
    transform.scale = stress::any_scale(dice, std::clamp(unit / shape.size, 1e-15, 1e15));
    transform.rotate_degrees = dice.chance(0.1) ? dice.vector(-1e9, 1e9) : dice.vector(-180, 180);
    if (dice.chance(0.1)) {
        transform.rotate_degrees = {};
    }
    const glm::dvec3 back = -(linear_part(transform) * shape.middle);
    if (glm::length(back) < 1e8) {
        transform.translate = back;
    }
    stress::any_material(dice, object.material);
    object.material.emission = family.emission ? dice.vector(0, 1) * dice.power_of_ten(-6, 6) : glm::dvec3(0);
    if (family.checker) {
        object.material.checker = Checker{static_cast<int>(1 + dice.below(9)), {dice.vector(0, 1), dice.vector(0, 1)}};
    }
    if (family.open) {
        object.material.texture = "marble.png";
    }
    const glm::dvec3 top = transform.translate + linear_part(transform) * (shape.middle + glm::dvec3(0, shape.size, 0));
    return {object, top};
}

} // namespace

StressScene stress_scene(std::uint32_t number, std::uint32_t seed) {
    number %= stress_families;
    const Family &family = families[number];
    StressDice dice(number, seed);
    StressScene out{{}, techniques_of(number)};
    Scene &scene = out.scene;
    const double unit = dice.chance(0.3) ? dice.power_of_ten(-1, 1) : dice.power_of_ten(-13, 8);
    scene.name = "stress " + std::to_string(number) + " " + std::to_string(seed);
    const PlacedObject placed = any_object(dice, family, unit);
    scene.objects = {placed.object};
    scene.blinn_exponent_scale = dice.chance(0.2) ? dice.one_of({1e-6, 0.1, 4.0, 16.0}) : 1;
    for (const char kind : family.lights) {
        scene.lights.push_back(stress::any_light(dice, kind, unit));
        keep_terms(scene.lights.back(), family.terms);
    }
    scene.camera = any_camera(dice, unit, family.open ? 0.5 : 0.1);
    if (dice.chance(0.3) && family.terms.find('s') != std::string_view::npos && !family.open) {
        zoom_on_highlight(scene, dice, unit);
    } else if (dice.chance(0.15) && glm::length(placed.top) > 0.01 * unit && glm::length(placed.top) < 1e8) {
        set_trap(scene, dice, placed.top);
    }
    if (family.orthographic) { // as large at the target as before
        scene.camera = with_projection(scene.camera, Projection::orthographic);
    }
    if (dice.chance(0.5)) { // as far as a double still tells the eye from what it looks at
        move_everything(scene, dice.direction() * std::min(unit * dice.power_of_ten(0, 12), 8e8));
    }
    scene.camera.position = glm::clamp(scene.camera.position, glm::dvec3(-farthest), glm::dvec3(farthest));
    return out;
}

} // namespace sandbox

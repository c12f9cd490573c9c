#include "tools/stress_parts.h"

#include <algorithm>

namespace sandbox::stress {
namespace {

constexpr double farthest = 1e9;

double coefficient(StressDice &dice, double per) {
    if (dice.chance(0.1)) {
        return dice.one_of({1e9, 1e-30});
    }
    return std::min(dice.power_of_ten(-6, 3) * per, 1e9);
}

double any_intensity(StressDice &dice) { return dice.chance(0.05) ? 1e6 : dice.power_of_ten(-6, 6); }

glm::dvec3 any_color(StressDice &dice) {
    glm::dvec3 color{dice.power_of_ten(-3, 3), dice.power_of_ten(-3, 3), dice.power_of_ten(-3, 3)};
    if (dice.chance(0.2)) {
        color[static_cast<int>(dice.below(3))] = dice.one_of({0.0, 1e-30, 1e6});
    }
    return color;
}

/// At the eye's distance or far away; in the object, on its surface perhaps, near its middle, at the limit.
glm::dvec3 any_position(StressDice &dice, double unit) {
    const glm::dvec3 way = dice.direction();
    switch (dice.below(10)) {
    case 0:
        return glm::dvec3(0);
    case 1:
        return way * unit * dice.power_of_ten(-6, 0.2);
    case 2:
        return way * (farthest / 10);
    default:
        return way * std::min(unit * 1.5 * dice.power_of_ten(0, 6), farthest / 10);
    }
}

void any_cone(StressDice &dice, Light &light, bool soft) {
    light.cutoff_degrees = dice.between(5, 90);
    if (dice.chance(0.25)) {
        light.cutoff_degrees = dice.chance(0.5) ? dice.one_of({0.0, 90.0, 90.0, 180.0}) : dice.power_of_ten(-6, 1);
    }
    const bool whole = light.cutoff_degrees == 180;
    light.inner_cutoff_degrees = soft && !whole ? light.cutoff_degrees * dice.one_of({0.0, 0.5, 0.9, 0.999999}) //
                                                : light.cutoff_degrees;
    light.exponent = !soft ? 0 : (dice.chance(0.1) ? 1e5 : dice.power_of_ten(0, 5));
}

} // namespace

StressShape any_shape(StressDice &dice) {
    const double size = dice.chance(0.7) ? 1 : dice.power_of_ten(-9, 8.9);
    switch (dice.below(8)) {
    case 0:
        return {SphereShape{size, 16, 24}, size};
    case 1:
        return {BoxShape{glm::dvec3(size), 3}, size};
    case 2:
        return {PlaneShape{glm::dvec2(size), 5}, size};
    case 3:
        return {CylinderShape{0.5 * size, size, 24, 2, dice.chance(0.5)}, size};
    case 4:
        return {TorusShape{size, 0.4 * size, 24, 12}, size};
    case 5:
        return {SphereShape{size, 2, 3}, size};
    default:
        break;
    }
    const char *const model = dice.one_of({"degenerate.obj", "huge-normals.obj", "opposite-normals.obj",
                                           "tiny-normals.obj", "zero-normals.obj", "far-origin.obj"});
    const bool far = std::string(model) == "far-origin.obj";
    return {ObjShape{model}, 1, far ? glm::dvec3(1e6, 0, 0) : glm::dvec3(0)};
}

StressShape open_shape(StressDice &dice) {
    const double size = dice.chance(0.7) ? 1 : dice.power_of_ten(-9, 8.9);
    switch (dice.below(4)) {
    case 0:
        return {PlaneShape{glm::dvec2(size), 5}, size};
    case 1:
        return {CylinderShape{0.5 * size, size, 24, 2, false}, size};
    default:
        return {ObjShape{TEST_DATA_DIR "/lighting/far-and-near-uvs.obj"}, 1};
    }
}

glm::dvec3 any_scale(StressDice &dice, double unit) {
    glm::dvec3 scale(unit);
    for (int axis = 0; axis < 3; ++axis) {
        scale[axis] *= dice.power_of_ten(-1, 0) * (dice.chance(0.2) ? -1 : 1);
    }
    const auto axis = static_cast<int>(dice.below(3));
    switch (dice.below(16)) {
    case 0:
        scale[axis] = 0;
        break;
    case 1:
        scale[axis] = 0;
        scale[(axis + 1) % 3] = 0;
        break;
    case 2:
        scale[axis] *= dice.power_of_ten(0, 6);
        break;
    case 3:
    case 4:
    case 5:
        scale[axis] *= dice.power_of_ten(-12, 0); // a disc; two such axes would be a line thinner than a pixel
        break;
    case 6:
    case 7:
    case 8:
        scale = glm::dvec3(unit);
        break;
    default:
        break;
    }
    return glm::clamp(scale, glm::dvec3(-1e15), glm::dvec3(1e15));
}

Light any_light(StressDice &dice, char kind, double unit) {
    Light light;
    light.type = kind == 'd' ? LightType::directional : kind == 'h' || kind == 's' ? LightType::spot : LightType::point;
    light.color = any_color(dice);
    light.ambient = any_intensity(dice) * 1e-3;
    light.diffuse = any_intensity(dice);
    light.specular = any_intensity(dice);
    light.position = any_position(dice, unit);
    const bool aimed = kind == 's' || kind == 'h';
    light.direction = aimed && light.position != glm::dvec3(0) ? -light.position : dice.direction();
    light.direction *= dice.power_of_ten(-12, 0);
    if (glm::length(light.direction) < 1e-30) {
        light.direction = dice.direction();
    }
    const bool all = kind == 'a' || kind == 's';
    if (all || kind == 'k' || kind == 'l' || kind == 'q') {
        light.attenuation = {all || kind == 'k' ? coefficient(dice, 1) : 0,
                             all || kind == 'l' ? coefficient(dice, 1 / unit) : 0,
                             all || kind == 'q' ? coefficient(dice, 1 / unit / unit) : 0};
        light.attenuate_ambient = true;
    }
    if (aimed) {
        any_cone(dice, light, kind == 's');
    }
    return light;
}

void any_material(StressDice &dice, Material &material) {
    material.shininess = dice.chance(0.15) ? dice.one_of({0.0, 1.0, 1e7}) : dice.power_of_ten(0, 7);
    material.diffuse = dice.chance(0.1) ? any_color(dice) : dice.vector(0, 1);
    material.specular = dice.chance(0.1) ? any_color(dice) : dice.vector(0, 1);
    material.ambient = dice.chance(0.1) ? any_color(dice) : dice.vector(0, 1);
}

} // namespace sandbox::stress

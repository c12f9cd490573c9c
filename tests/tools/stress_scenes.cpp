#include "tools/stress_scenes.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace sandbox {
namespace {

/// Random numbers that are the same with every standard library: an odd multiplier, then bits mixed (PCG's idea).
class Dice {
  public:
    Dice(std::uint32_t family, std::uint32_t seed) : state_(std::uint64_t{seed} << 32 | family) {
        next();
        next();
    }
    std::uint32_t next() {
        state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
        std::uint64_t x = state_;
        x ^= x >> 31;
        x *= 0x9E3779B97F4A7C15ULL;
        return static_cast<std::uint32_t>(x >> 32);
    }
    double between(double low, double high) { return low + (high - low) * (next() / 4294967296.0); }
    double power_of_ten(double low, double high) { return std::pow(10, between(low, high)); }
    bool chance(double share) { return between(0, 1) < share; }
    glm::dvec3 direction() {
        while (true) {
            const glm::dvec3 v(between(-1, 1), between(-1, 1), between(-1, 1));
            if (const double length = glm::length(v); length > 0.1 && length < 1) {
                return v / length;
            }
        }
    }

  private:
    std::uint64_t state_;
};

Shape any_shape(Dice &dice) {
    switch (dice.next() % 5) {
    case 0:
        return SphereShape{1, 16, 24};
    case 1:
        return BoxShape{{1, 1, 1}, 3};
    case 2:
        return PlaneShape{{2, 2}, 5};
    case 3:
        return CylinderShape{0.5, 1, 24, 2, true};
    default:
        return TorusShape{1, 0.4, 24, 12};
    }
}

Attenuation any_attenuation(Dice &dice, double unit) {
    const auto coefficient = [&](double per) { return std::min(dice.power_of_ten(-6, 3) * per, 1e9); };
    return {coefficient(1), coefficient(1 / unit), coefficient(1 / unit / unit)};
}

/// `kind`: 0 directional, 1 point, 2 attenuated point, 3 hard spot, 4 soft spot with an exponent.
Light any_light(Dice &dice, std::uint32_t kind, double unit) {
    Light light;
    light.type = kind == 0 ? LightType::directional : (kind < 3 ? LightType::point : LightType::spot);
    light.color = {dice.power_of_ten(-3, 3), dice.power_of_ten(-3, 3), dice.power_of_ten(-3, 3)};
    light.ambient = dice.power_of_ten(-6, 0);
    light.diffuse = dice.power_of_ten(-6, 6);
    light.specular = dice.power_of_ten(-6, 6);
    light.position = dice.direction() * std::min(unit * 1.5 * dice.power_of_ten(0, 6), 1e8);
    light.direction = (light.type == LightType::spot ? -light.position : dice.direction()) * dice.power_of_ten(-8, 0);
    if (kind == 2 || kind == 4) {
        light.attenuation = any_attenuation(dice, unit);
        light.attenuate_ambient = true;
    }
    if (light.type == LightType::spot) {
        light.cutoff_degrees = dice.chance(0.1) ? 90 : dice.between(5, 90);
        light.inner_cutoff_degrees = kind == 4 ? light.cutoff_degrees * dice.between(0, 0.9) : light.cutoff_degrees;
        light.exponent = kind == 4 ? dice.power_of_ten(0, 5) : 0;
    }
    return light;
}

/// The camera goes so near to where the first light is mirrored that a stiff highlight fills the picture.
void zoom_on_highlight(Scene &scene, Dice &dice) {
    scene.objects[0].mesh = SphereShape{1, 16, 24};
    scene.objects[0].transform.scale = glm::dvec3(glm::length(scene.objects[0].transform.scale));
    const glm::dvec3 eye = scene.camera.position;
    const double width = 1 / std::sqrt(std::max(scene.objects[0].material.shininess, 1.0));
    const glm::dvec3 beside = glm::normalize(eye) + width * dice.direction();
    Light &light = scene.lights[0];
    light.position = beside * glm::length(light.position);
    light.direction = -beside;
    light.specular = 1;
    light.diffuse = light.ambient = 0.01;
    scene.camera.fov_y_degrees *= std::min(3 * width, 1.0);
}

void move_everything(Scene &scene, const glm::dvec3 &by) {
    scene.camera.position += by;
    scene.camera.target += by;
    scene.objects[0].transform.translate += by;
    for (Light &light : scene.lights) {
        light.position += by;
    }
}

Technique technique_of(std::uint32_t family) {
    constexpr std::array<Frequency, 5> frequencies{Frequency::per_pixel, Frequency::per_vertex,
                                                   Frequency::interpolated_vectors, Frequency::hybrid, Frequency::flat};
    Technique technique;
    technique.frequency = frequencies[family % 5];
    technique.model = family / 5 % 2 == 0 ? Model::blinn_phong : Model::phong;
    technique.program = family % 6 == 5 ? Program::full : Program::specialised;
    return technique;
}

} // namespace

StressScene stress_scene(std::uint32_t family, std::uint32_t seed) {
    family %= stress_families;
    Dice dice(family, seed);
    StressScene out{{}, technique_of(family)};
    Scene &scene = out.scene;
    const double unit = dice.power_of_ten(-9, 8); // the object's size; every other length follows it
    const double spread = dice.chance(0.5) ? 0 : 3;
    Object object{"object", any_shape(dice), {}, {}, dice.chance(0.3)};
    for (int axis = 0; axis < 3; ++axis) {
        object.transform.scale[axis] = unit * dice.power_of_ten(-spread, 0) * (dice.chance(0.2) ? -1 : 1);
        object.transform.rotate_degrees[axis] = dice.between(-180, 180);
    }
    object.material.shininess = dice.chance(0.1) ? 0 : dice.power_of_ten(0, 7);
    object.material.diffuse = {dice.between(0, 1), dice.between(0, 1), dice.between(0, 1)};
    scene.objects = {object};
    for (std::uint32_t i = 0; i <= family / 10 % 3; ++i) {
        scene.lights.push_back(any_light(dice, (family / 2 + 2 * i) % 5, unit));
    }
    const double distance = unit * dice.power_of_ten(0.3, 1);
    scene.camera.position = dice.direction() * distance;
    scene.camera.up = dice.direction() * dice.power_of_ten(-3, 3);
    scene.camera.fov_y_degrees = std::min(glm::degrees(2 * std::atan(1.5 * unit / distance)), 120.0);
    scene.camera.near_plane = distance * dice.power_of_ten(-4, -1);
    scene.camera.far_plane = distance * dice.power_of_ten(1, 4);
    if (dice.chance(0.4)) {
        zoom_on_highlight(scene, dice);
    }
    if (dice.chance(0.5)) { // as far as a double still holds the object
        move_everything(scene, dice.direction() * std::min(unit * dice.power_of_ten(0, 7), 8e8));
    }
    return out;
}

} // namespace sandbox

#include "tools/masks/spiteful_scenes.h"

#include "scene/mesh.h"
#include "scene/space.h"
#include "tools/random_scene.h"
#include "tools/stress_scenes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>
#include <variant>
#include <vector>

namespace sandbox {
namespace {

class Dice {
  public:
    explicit Dice(unsigned seed) : random_(seed) {}
    unsigned below(std::size_t count) { return static_cast<unsigned>(random_()) % static_cast<unsigned>(count); }
    bool one_in(unsigned count) { return below(count) == 0; }
    double between(double low, double high) { return low + (high - low) * static_cast<double>(random_()) / 0x1p32; }
    double power_of_ten(double low, double high) { return std::pow(10.0, between(low, high)); }

  private:
    std::mt19937 random_;
};

/// A vertex of a built-in shape, in the world.
glm::dvec3 a_vertex(Dice &dice, const Object &object) {
    if (std::holds_alternative<ObjShape>(object.mesh)) {
        return object.transform.translate;
    }
    const Mesh mesh = build_mesh(object.mesh);
    return linear_part(object.transform) * mesh.positions[dice.below(mesh.positions.size())] +
           object.transform.translate;
}

void place_a_light(Dice &dice, Scene &scene) {
    Light &light = scene.lights[dice.below(scene.lights.size())];
    const Object &object = scene.objects[dice.below(scene.objects.size())];
    light.type = dice.one_in(2) ? LightType::point : LightType::spot;
    light.position = dice.one_in(4) ? object.transform.translate : a_vertex(dice, object);
    if (dice.one_in(3)) {
        light.position.y += dice.power_of_ten(-9, -1);
    }
}

void darken(Dice &dice, Scene &scene) {
    Light &light = scene.lights[dice.below(scene.lights.size())];
    Material &material = scene.objects[dice.below(scene.objects.size())].material;
    switch (dice.below(6)) {
    case 0:
        light.color = {};
        break;
    case 1:
        light.diffuse = light.specular = 0;
        break;
    case 2:
        material.specular = {};
        break;
    case 3:
        material.diffuse = material.ambient = {};
        break;
    case 4:
        material.texture.clear();
        material.checker = Checker{4, {glm::dvec3(0), glm::dvec3(0)}};
        break;
    default:
        light.color = {0, 1, 0};
        material.diffuse = material.specular = {1, 0, 1};
        break;
    }
}

void sharpen(Dice &dice, Scene &scene) {
    Light &light = scene.lights[dice.below(scene.lights.size())];
    Object &object = scene.objects[dice.below(scene.objects.size())];
    switch (dice.below(5)) {
    case 0:
        light.type = LightType::spot;
        light.direction = object.transform.translate - light.position + glm::dvec3(1e-3, 0, 0);
        light.cutoff_degrees = light.inner_cutoff_degrees = dice.between(1, 60);
        break;
    case 1:
        object.material.shininess = dice.between(0.01, 0.6);
        break;
    case 2:
        object.two_sided = true;
        break;
    case 3:
        object.material.texture.clear();
        object.material.checker = Checker{64, {glm::dvec3(0.2), glm::dvec3(1)}};
        break;
    default:
        light.type = LightType::directional; // along a floor
        light.direction = {dice.between(-1, 1), dice.one_in(2) ? 0 : dice.power_of_ten(-9, -3), 1};
        break;
    }
}

void coincide(Dice &dice, Scene &scene) {
    Object copy = scene.objects[dice.below(scene.objects.size())];
    copy.transform.scale *= 1 - dice.power_of_ten(-9, -1);
    scene.objects.push_back(copy);
}

void look_strangely(Dice &dice, Scene &scene) {
    Camera &camera = scene.camera;
    switch (dice.below(3)) {
    case 0:
        camera.near_plane = dice.power_of_ten(-7, -2);
        camera.far_plane = dice.power_of_ten(2, 6);
        break;
    case 1: { // as large as before, from afar
        const double times = dice.power_of_ten(0, 4);
        const glm::dvec3 back = camera.position - camera.target;
        camera.position = camera.target + times * back;
        camera.fov_y_degrees = std::min(camera.fov_y_degrees / times, camera.fov_y_degrees);
        camera.near_plane = 0.2 * times * glm::length(back);
        camera.far_plane = 5 * times * glm::length(back);
        break;
    }
    default:
        scene.objects[dice.below(scene.objects.size())].transform.scale.y *= dice.power_of_ten(-6, 0);
        break;
    }
}

} // namespace

SpitefulScene spiteful_scene(unsigned seed) {
    Dice dice(seed ^ 0x9e3779b9U);
    if (dice.one_in(5)) {
        const StressScene stress = stress_scene(seed % stress_families, seed / stress_families);
        return {stress.scene, stress.techniques[dice.below(stress.techniques.size())]};
    }
    SpitefulScene spiteful{random_scene(seed), random_technique(seed)};
    spiteful.technique.program = Program::specialised; // programs are the other tests' business
    Scene &scene = spiteful.scene;
    if (scene.lights.empty() || scene.objects.empty()) {
        return spiteful;
    }
    const std::array twists{place_a_light, darken, sharpen, coincide, look_strangely};
    const unsigned count = 1 + dice.below(4);
    for (unsigned i = 0; i < count; ++i) {
        twists[dice.below(twists.size())](dice, scene);
    }
    return spiteful;
}

std::optional<Technique> with_a_fault(const Scene &scene, const Technique &technique, unsigned seed) {
    std::vector<Technique> faulty;
    for (const TechniqueKey &key : technique_settings) {
        for (int value = 1; key.is_fault() && value < static_cast<int>(key.values.size()); ++value) {
            Technique changed = technique;
            key.set(changed, value);
            if (key.get(technique) != value && !why_refused(changed) && can_matter(key, value, scene, changed)) {
                faulty.push_back(changed);
            }
        }
    }
    return faulty.empty() ? std::nullopt : std::optional(faulty[Dice(seed).below(faulty.size())]);
}

} // namespace sandbox

#include "tools/random_scene.h"

#include "scene/light_kind.h"
#include "scene/mesh.h"
#include "scene/orbit.h"

#include <array>
#include <glm/geometric.hpp>
#include <random>

namespace sandbox {
namespace {

/// By the generator's bits alone: the library's distributions differ between machines.
class Dice {
  public:
    explicit Dice(unsigned seed) : random_(seed) {}

    int below(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }
    bool one_in(int count) { return below(count) == 0; }
    double between(double low, double high) { return low + (high - low) * static_cast<double>(random_()) / 0x1p32; }
    glm::dvec3 vector(double low, double high) {
        const double x = between(low, high);
        const double y = between(low, high);
        return {x, y, between(low, high)};
    }
    template <class Values> auto one_of(const Values &values) {
        return values[static_cast<std::size_t>(below(static_cast<int>(values.size())))];
    }

  private:
    std::mt19937 random_;
};

Shape random_shape(Dice &dice) {
    switch (dice.below(6)) {
    case 0:
        return SphereShape{dice.between(0.6, 1.2), 8 + dice.below(12), 12 + dice.below(16)};
    case 1:
        return BoxShape{dice.vector(0.6, 1.6), 1 + dice.below(4)};
    case 2:
        return PlaneShape{{dice.between(1, 4), dice.between(1, 4)}, 1 + dice.below(8)};
    case 3:
        return CylinderShape{dice.between(0.3, 0.8), dice.between(0.5, 2), 12 + dice.below(20), 1 + dice.below(4),
                             !dice.one_in(3)};
    case 4:
        return ObjShape{TEST_DATA_DIR "/lighting/far-and-near-uvs.obj"}; // open, and its texture repeats far away
    default:
        return TorusShape{dice.between(0.7, 1), dice.between(0.2, 0.45), 16 + dice.below(16), 10 + dice.below(10)};
    }
}

Material random_material(Dice &dice) {
    constexpr std::array shininess{0.0, 0.5, 1.0, 2.0, 8.0, 32.0, 128.0, 1024.0, 5000.0};
    Material material;
    material.ambient = dice.vector(0, 1);
    material.diffuse = dice.vector(0, 1);
    material.specular = dice.one_in(6) ? glm::dvec3(0) : dice.vector(0, 1);
    material.emission = dice.one_in(4) ? dice.vector(0, 0.3) : glm::dvec3(0);
    material.shininess = dice.one_of(shininess);
    material.texture_modulates_specular = dice.one_in(2);
    if (dice.one_in(4)) {
        material.texture = "marble.png";
    } else if (dice.one_in(4)) {
        material.checker = Checker{2 + dice.below(9), {dice.vector(0, 1), dice.vector(0, 1)}};
    }
    return material;
}

Transform random_transform(Dice &dice) {
    Transform transform;
    transform.translate = dice.vector(-0.8, 0.8);
    transform.rotate_degrees = dice.one_in(4) ? glm::dvec3(0) : dice.vector(-180, 180);
    switch (dice.below(4)) {
    case 0:
        transform.scale = dice.vector(0.5, 1.5);
        break;
    case 1:
        transform.scale = glm::dvec3(dice.between(0.5, 1.5));
        break;
    case 2:
        transform.scale = {-dice.between(0.5, 1.5), 1, 1}; // mirrored
        break;
    default:
        break;
    }
    return transform;
}

Light random_light(Dice &dice) {
    Light light;
    light.type = dice.one_of(light_kinds).type;
    light.enabled = !dice.one_in(8);
    light.color = dice.vector(0.2, 1);
    light.ambient = dice.one_in(2) ? dice.between(0, 0.3) : 0;
    light.diffuse = dice.one_in(6) ? 0 : dice.between(0.2, 1);
    light.specular = dice.one_in(6) ? 0 : dice.between(0.2, 1);
    light.attenuate_ambient = dice.one_in(2);
    light.position = dice.vector(-3, 3);
    light.direction = -light.position + dice.vector(-1, 1);
    if (dice.one_in(2)) {
        light.attenuation = {dice.between(0.2, 1), dice.between(0, 0.3), dice.between(0, 0.2)};
    }
    light.cutoff_degrees = light.inner_cutoff_degrees = dice.one_of(std::array{10.0, 25.0, 45.0, 90.0, 180.0});
    if (dice.one_in(2) && light.cutoff_degrees < 180) {
        light.inner_cutoff_degrees = light.cutoff_degrees * dice.between(0.2, 0.9);
    }
    light.exponent = dice.one_of(std::array{0.0, 0.0, 1.0, 8.0, 64.0});
    return light;
}

} // namespace

Scene random_scene(unsigned seed) {
    Dice dice(seed);
    Scene scene;
    scene.name = "random " + std::to_string(seed);
    scene.camera.position = glm::normalize(dice.vector(-1, 1) + glm::dvec3(0, 0.3, 0)) * dice.between(4, 7);
    scene.camera.target = dice.vector(-0.3, 0.3);
    if (dice.one_in(4)) {
        scene.camera = with_projection(scene.camera, Projection::orthographic);
    }
    scene.ambient = dice.one_in(2) ? dice.vector(0, 0.2) : glm::dvec3(0);
    scene.blinn_exponent_scale = dice.one_in(3) ? 4 : 1;
    for (int i = dice.below(4); i >= 0; --i) {
        scene.lights.push_back(random_light(dice));
    }
    for (int i = dice.below(3); i >= 0; --i) {
        const Shape shape = random_shape(dice);
        const bool closed = !std::holds_alternative<ObjShape>(shape) && build_mesh(shape).closed;
        Object object{"object " + std::to_string(i), shape, random_transform(dice), random_material(dice),
                      closed ? dice.one_in(3) : !dice.one_in(3)};
        object.material.texture_color_space = dice.one_in(2) ? ColorSpace::srgb : ColorSpace::linear;
        scene.objects.push_back(object);
    }
    return scene;
}

Technique random_technique(unsigned seed) {
    Dice dice(seed);
    while (true) {
        Technique technique;
        for (const TechniqueKey &key : technique_keys()) {
            if (key.name == "precision") {
                continue; // half has its own tests
            }
            const bool models = key.name == model_key.name; // own shading needs a text
            const int count = static_cast<int>(models ? all_models.size() : key.values.size());
            // Frequency, model, power, program anyhow; faults one in three, so that many are seen alone.
            const int value = dice.below(count);
            key.set(technique, key.is_fault() && !dice.one_in(3) ? 0 : value);
        }
        // What pow(0, 0) gives no bound can know, and (scale x cosine)^n leaves any: both have tests of their own.
        const bool bounded = technique.power != Power::naive && technique.normals != Normals::unnormalized;
        if (bounded && !why_refused(technique)) {
            return technique;
        }
    }
}

} // namespace sandbox

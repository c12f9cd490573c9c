#include "render/light_values.h"

#include "scene/light_kind.h"
#include "scene/space.h"
#include "scene/unit.h"

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace sandbox {
namespace {

/// The same attenuation per scaled length, within float32 (beyond it nothing is lit).
Attenuation scaled(const Attenuation &a, double scale) {
    constexpr double most = 3e38;
    return {a.constant, std::min(a.linear / scale, most), std::min(a.quadratic / scale / scale, most)};
}

/// One half vector for the whole scene: the light seen from the world's origin, and the view axis. Under an infinite
/// viewer that is exact for a directional light.
glm::dvec3 scene_half_vector(const Light &light, const Scene &scene) {
    const glm::dvec3 to_light = has_position(light) ? unit(light.position) : -unit(light.direction);
    return unit(to_light - camera_axes(scene.camera).forward);
}

} // namespace

LightValues light_values(const Scene &scene, const ObjectLight &on_object, const Material &material,
                         const EyeSpace &space) {
    const Light &light = scene.lights[on_object.index];
    LightValues values;
    values.position = (light.position - space.lit_origin) * space.lit_scale;
    values.direction = unit(light.direction);
    if (on_object.ambient || on_object.attenuated_ambient) {
        (on_object.ambient ? values.ambient : values.attenuated_ambient) =
            material.ambient * light.color * light.ambient;
    }
    values.diffuse = material.diffuse * light.color * (light.diffuse * on_object.diffuse_factor);
    if (on_object.specular) {
        values.specular = material.specular * light.color * (light.specular * on_object.specular_factor);
    }
    values.specular_share = specular_share(material, light, on_object);
    values.half_vector = scene_half_vector(light, scene);
    values.attenuation = scaled(light.attenuation, space.lit_scale);
    if (has_cone(light)) {
        values.cos_cutoff = cos_degrees(light.cutoff_degrees);
        values.cos_inner_cutoff = cos_degrees(light.inner_cutoff_degrees);
        const double sine = std::sin(glm::radians(light.cutoff_degrees));
        values.sin2_cutoff = sine * sine;
        const double inner = std::sin(glm::radians(light.inner_cutoff_degrees) / 2);
        const double outer = std::sin(glm::radians(light.cutoff_degrees) / 2);
        const double edge = 2 * (outer - inner) * (outer + inner); // a difference of cosines near 1 has no digits left
        values.edge_sharpness = light.inner_cutoff_degrees < light.cutoff_degrees ? 1 / std::max(edge, 1e-30) : 0;
        values.exponent = light.exponent;
    }
    return values;
}

void put_shared(UniformSink &sink, const std::string &prefix, const LightValues &light) {
    const auto number = [&](const char *member, double value) { sink.put(prefix + member, static_cast<float>(value)); };
    number("specular_share", light.specular_share);
    number("constant", light.attenuation.constant);
    number("linear", light.attenuation.linear);
    number("quadratic", light.attenuation.quadratic);
}

void put_light(UniformSink &sink, const std::string &name, const LightValues &light) {
    const auto vector = [&](const char *member, const glm::dvec3 &value) { sink.put(name + member, glm::vec3(value)); };
    const auto number = [&](const char *member, double value) { sink.put(name + member, static_cast<float>(value)); };
    vector(".position", light.position);
    vector(".direction", light.direction);
    vector(".ambient", light.ambient);
    vector(".attenuated_ambient", light.attenuated_ambient);
    vector(".diffuse", light.diffuse);
    vector(".specular", light.specular);
    vector(".half_vector", light.half_vector);
    put_shared(sink, name + ".", light);
    number(".cos_cutoff", light.cos_cutoff);
    number(".cos_inner_cutoff", light.cos_inner_cutoff);
    number(".sin2_cutoff", light.sin2_cutoff);
    number(".edge_sharpness", light.edge_sharpness);
    number(".exponent", light.exponent);
}

} // namespace sandbox

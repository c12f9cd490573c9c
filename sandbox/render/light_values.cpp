#include "render/light_values.h"

#include "scene/space.h"
#include "shading/features.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace sandbox {
namespace {

glm::dvec3 unit(const glm::dvec3 &v) {
    const double length = glm::length(v);
    return length > 0 ? v / length : glm::dvec3(0);
}

/// The same attenuation per scaled length, within float32 (beyond it nothing is lit).
Attenuation scaled(const Attenuation &a, double scale) {
    constexpr double most = 3e38;
    return {a.constant, std::min(a.linear / scale, most), std::min(a.quadratic / scale / scale, most)};
}

/// The cosine of an angle in degrees, exactly 0 at 90.
double cos_degrees(double degrees) { return degrees == 90 ? 0 : std::cos(glm::radians(degrees)); }

/// One half vector for the whole scene: the light seen from the world's origin, and the view axis. Under an infinite
/// viewer that is exact for a directional light.
glm::dvec3 scene_half_vector(const Light &light, const Scene &scene) {
    const glm::dvec3 to_light = light.type == LightType::directional ? -unit(light.direction) : unit(light.position);
    return unit(to_light - camera_axes(scene.camera).forward);
}

} // namespace

LightValues light_values(const Light &light, const Scene &scene, const Technique &technique, const Material &material,
                         double scale) {
    LightValues values;
    const bool cone = light.type == LightType::spot && light.cutoff_degrees != 180;
    values.type = light.type == LightType::directional ? 0 : (cone ? 2 : 1);
    values.position = (light.position - scene.camera.position) * scale;
    values.direction = unit(light.direction);
    if (ambient_with_light(light, technique)) {
        (light.attenuate_ambient && fades(light) ? values.attenuated_ambient : values.ambient) =
            material.ambient * light.color * light.ambient;
    }
    values.diffuse = material.diffuse * light.color * light.diffuse;
    values.specular =
        technique.model == Model::lambert ? glm::dvec3(0) : material.specular * light.color * light.specular;
    values.half_vector = scene_half_vector(light, scene);
    values.attenuation = scaled(light.attenuation, scale);
    if (cone) {
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

glm::dvec3 constant_ambient_light(const Scene &scene, const Technique &technique, const Material &material) {
    glm::dvec3 sum = scene.ambient;
    for (const Light &light : scene.lights) {
        if (light.enabled && !ambient_with_light(light, technique)) {
            sum += light.color * light.ambient;
        }
    }
    return material.ambient * sum;
}

} // namespace sandbox

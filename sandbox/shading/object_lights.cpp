#include "shading/object_lights.h"

#include "shading/features.h"

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <numbers>

namespace sandbox {

ShiningTerms terms_on(const Object &object, const Light &light, Model model) {
    const auto shines = [&](double intensity, const glm::dvec3 &color) {
        return light.enabled && intensity != 0 && light.color * color != glm::dvec3(0);
    };
    return {.ambient = shines(light.ambient, object.material.ambient),
            .diffuse = shines(light.diffuse, object.material.diffuse),
            .specular = reflection(model).specular && shines(light.specular, object.material.specular)};
}

double specular_share(const Material &material, const Light &light, const ObjectLight &on_object) {
    const auto largest = [](const glm::dvec3 &color) { return std::max({color.x, color.y, color.z}); };
    const double diffuse = largest(material.diffuse * light.color) * light.diffuse * on_object.diffuse_factor;
    const double specular = largest(material.specular * light.color) * light.specular * on_object.specular_factor;
    return on_object.specular && diffuse > 0 ? specular / diffuse : 0;
}

bool has_soft_edge(const Light &light) { return light.inner_cutoff_degrees < light.cutoff_degrees; }

bool is_narrow_cone(const Light &light) {
    // A float32 cosine errs by 6e-8: by more than 1e-4 of an edge or a cone this narrow.
    constexpr double narrow = 6e-4;
    const double outer = std::cos(glm::radians(light.cutoff_degrees));
    const double inner = std::cos(glm::radians(light.inner_cutoff_degrees));
    return 1 - outer < narrow || (has_soft_edge(light) && inner - outer < narrow);
}

bool fades(const Light &light) {
    return (has_position(light) && light.attenuation != Attenuation{}) || has_cone(light);
}

bool ambient_with_light(const Light &light, const Technique &technique) {
    return technique.ambient == AmbientWhere::where_lit || (light.attenuate_ambient && fades(light));
}

ObjectLights lights_on_object(const Scene &scene, const Technique &technique, const Object &object, LightSet seen) {
    ObjectLights result;
    const bool normalised = technique.normalisation == Normalisation::blinn_phong;
    const double n = raised_exponent(scene, technique.model, object.material);
    glm::dvec3 constant = scene.ambient;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const Light &light = scene.lights[i];
        const ShiningTerms terms = terms_on(object, light, technique.model);
        const bool own_ambient = ambient_with_light(light, technique);
        if (light.enabled && !own_ambient) {
            constant += light.color * light.ambient;
        }
        const bool ambient = own_ambient && terms.ambient;
        const bool attenuated = light.attenuate_ambient && fades(light);
        if ((seen >> i & 1) != 0 && (ambient || terms.diffuse || terms.specular)) {
            result.of_kind[drawn_type(light)].push_back(
                {.index = i,
                 .ambient = ambient && !attenuated,
                 .attenuated_ambient = ambient && attenuated,
                 .diffuse = terms.diffuse,
                 .specular = terms.specular,
                 .diffuse_factor = normalised ? std::numbers::inv_pi : 1,
                 .specular_factor = normalised ? (n + 8) / (8 * std::numbers::pi) : 1});
        }
    }
    result.constant_ambient = object.material.ambient * constant;
    return result;
}

} // namespace sandbox

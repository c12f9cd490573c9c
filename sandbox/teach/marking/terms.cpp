#include "teach/marking/terms.h"

#include "scene/light_kind.h"

#include <utility>

namespace sandbox {
namespace {

void keep(Light &light, const MarkTerms &terms) {
    for (const LightTerm &row : light_terms) {
        light.*row.intensity *= terms.contains(row.term) ? 1 : 0;
    }
}

} // namespace

Scene dark(Scene scene) { return only_terms(std::move(scene), {}); }

Scene only_terms(Scene scene, const MarkTerms &terms) {
    for (Light &light : scene.lights) {
        keep(light, terms);
    }
    scene.ambient *= terms.contains(MarkTerm::ambient) ? 1 : 0;
    return scene;
}

Scene only_light(const Scene &scene, std::size_t light, const MarkTerms &terms) {
    Scene lit = dark(scene);
    lit.lights[light] = scene.lights[light];
    keep(lit.lights[light], terms);
    std::swap(lit.lights[0], lit.lights[light]);
    return lit;
}

Scene only_scene_ambient(const Scene &scene) {
    Scene lit = dark(scene);
    lit.ambient = scene.ambient;
    return lit;
}

Scene neutral(Scene scene, const MarkTerms &terms) {
    for (Light &light : scene.lights) {
        if (terms.contains(MarkTerm::attenuation)) {
            light.attenuation = {};
        }
        if (terms.contains(MarkTerm::cone) && has_cone(light)) {
            light.cutoff_degrees = 180; // no cone; and for who does not know that, one as wide as half of all
            light.inner_cutoff_degrees = 90;
            light.exponent = 0;
        }
    }
    for (Object &object : scene.objects) {
        if (terms.contains(MarkTerm::normals)) {
            object.transform.rotate_degrees = glm::dvec3(0);
            object.transform.scale = glm::dvec3(1);
        }
    }
    return scene;
}

bool light_has(const Light &light, MarkTerm term) {
    switch (term) {
    case MarkTerm::attenuation:
        return has_position(light) && light.attenuation != Attenuation{};
    case MarkTerm::cone:
        return has_cone(light);
    default:
        break;
    }
    for (const LightTerm &row : light_terms) {
        if (row.term == term) {
            return light.*row.intensity != 0 && light.color != glm::dvec3(0);
        }
    }
    return true;
}

} // namespace sandbox

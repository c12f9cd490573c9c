#include "shading/technique_rules.h"

#include "scene/space.h"
#include "shading/features.h"

#include <algorithm>
#include <stdexcept>

namespace sandbox::rules {
namespace {

bool lights_pixels(const Technique &t) {
    return t.frequency == Frequency::per_pixel || t.frequency == Frequency::automatic ||
           t.frequency == Frequency::interpolated_vectors ||
           (t.frequency == Frequency::hybrid && reflection(t.model).specular);
}

/// Does any light of the scene satisfy `asks(light, its terms on the object)`?
bool any_light(const Scene &scene, const Object &object, const Technique &technique, const auto &asks) {
    return std::ranges::any_of(
        scene.lights, [&](const Light &light) { return asks(light, terms_on(object, light, technique.model)); });
}

bool reads_normals(const Scene &scene, const Object &object, const Technique &technique) {
    const bool where_lit = technique.ambient == AmbientWhere::where_lit;
    return any_light(scene, object, technique, [&](const Light &, const ShiningTerms &terms) {
        return terms.diffuse || terms.specular || (terms.ambient && where_lit);
    });
}

/// Is some exponent of the object's highlights or of a cone that reaches it in (0, infinity) and as asked?
bool raises(const Scene &scene, const Object &object, const Technique &technique, bool (*asked)(double)) {
    const double n = raised_exponent(scene, technique.model, object.material);
    return any_light(scene, object, technique, [&](const Light &light, const ShiningTerms &terms) {
        const bool cone = has_cone(light);
        const bool fades = terms.diffuse || terms.specular || (terms.ambient && light.attenuate_ambient);
        return (terms.specular && n != 1 && asked(n)) || (cone && fades && asked(light.exponent));
    });
}

} // namespace

std::string_view needs_unit_normals_per_pixel(const Technique &technique) {
    if (!lights_pixels(technique)) {
        return "can have no effect: no normal is interpolated under this frequency and model";
    }
    return technique.normals == Normals::unnormalized
               ? "can have no effect: normals=unnormalized makes no normal unit anywhere"
               : "";
}

std::string_view needs_specular(const Technique &technique) {
    return reflection(technique.model).specular ? "" : "can have no effect: the reflection model has no specular term";
}

std::string_view needs_half_vector(const Technique &technique) {
    return reflection(technique.model).half_vector ? "" : "can have no effect: the reflection model has no half vector";
}

std::string_view needs_attenuation_per_pixel(const Technique &technique) {
    if (!lights_pixels(technique)) {
        return "can have no effect: nothing is attenuated per pixel under this frequency and model";
    }
    return technique.program == Program::full ? "needs a varying for every light, which program=full does not carry"
                                              : "";
}

std::string_view needs_exact_distances(const Technique &technique) {
    return technique.frequency == Frequency::interpolated_vectors
               ? "can have no effect: interpolated-vectors always interpolates the distance"
               : needs_attenuation_per_pixel(technique);
}

std::string_view needs_own_text(const Technique &technique) {
    if (technique.frequency == Frequency::interpolated_vectors || technique.frequency == Frequency::hybrid ||
        technique.frequency == Frequency::automatic) {
        return "is for flat, per-vertex and per-pixel: other frequencies take the equation apart";
    }
    return technique.own ? "" : "needs a text, which --own FILE.glsl names where a command takes it";
}

std::string_view needs_specialised_program(const Technique &technique) {
    return technique.program == Program::full ? "needs a program without guards, and program=full keeps them" : "";
}

std::string_view needs_rounded_pixels(const Technique &technique) {
    if (!lights_pixels(technique)) {
        return "rounds what is lit per pixel, and this frequency and model light nothing there";
    }
    switch (technique.program) {
    case Program::specialised:
        return "";
    case Program::baked:
        return "rounds every operation, and program=baked has some done beforehand";
    case Program::full:
        return "rounds the program of one scene, and program=full is for all";
    }
    throw std::logic_error("no such program");
}

bool has_light(const Scene &scene, const Object &object, const Technique &technique) {
    return any_light(scene, object, technique, [](const Light &, const ShiningTerms &terms) {
        return terms.ambient || terms.diffuse || terms.specular;
    });
}

bool has_diffuse_or_specular(const Scene &scene, const Object &object, const Technique &technique) {
    return any_light(scene, object, technique,
                     [](const Light &, const ShiningTerms &terms) { return terms.diffuse || terms.specular; });
}

bool has_specular(const Scene &scene, const Object &object, const Technique &technique) {
    return any_light(scene, object, technique, [](const Light &, const ShiningTerms &terms) { return terms.specular; });
}

bool has_light_ambient(const Scene &scene, const Object &object, const Technique &technique) {
    return any_light(scene, object, technique, [](const Light &, const ShiningTerms &terms) { return terms.ambient; });
}

bool has_directional_diffuse(const Scene &scene, const Object &object, const Technique &technique) {
    return any_light(scene, object, technique, [](const Light &light, const ShiningTerms &terms) {
        return terms.diffuse && !has_position(light);
    });
}

bool reads_view(const Scene &scene, const Object &object, const Technique &technique) {
    if (is_orthographic(scene.camera)) {
        return false; // V is the same at every point anyhow
    }
    const bool constant_highlight = reflection(technique.model).half_vector &&
                                    technique.half_vector == HalfVector::constant &&
                                    technique.gate != Gate::view_facing;
    return (technique.facing == Facing::view && turns_normals(scene, object, technique)) ||
           (!constant_highlight && has_specular(scene, object, technique));
}

bool scales_normals_unevenly(const Scene &scene, const Object &object, const Technique &technique) {
    return !scales_evenly(linear_part(object.transform)) && reads_normals(scene, object, technique);
}

bool transforms_normals(const Scene &scene, const Object &object, const Technique &technique) {
    const glm::dmat3 linear = linear_part(object.transform);
    const bool only_grows = linear[0][0] > 0 && linear == glm::dmat3(linear[0][0]);
    return !only_grows && reads_normals(scene, object, technique);
}

bool turns_normals(const Scene &scene, const Object &object, const Technique &technique) {
    return object.two_sided && reads_normals(scene, object, technique);
}

bool mirrors_normals(const Scene &scene, const Object &object, const Technique &technique) {
    return is_mirrored(object.transform) && reads_normals(scene, object, technique);
}

bool turns_normals_to_view(const Scene &scene, const Object &object, const Technique &technique) {
    return world_to_view_axes(scene.camera) != glm::dmat3(1) && reads_normals(scene, object, technique);
}

bool reads_normal_lengths(const Scene &scene, const Object &object, const Technique &technique) {
    const bool keeps_lengths = glm::abs(object.transform.scale) == glm::dvec3(1);
    return keeps_lengths ? lights_pixels(technique) && reads_normals_per_pixel(scene, object, technique)
                         : reads_normals(scene, object, technique);
}

bool reads_normals_per_pixel(const Scene &scene, const Object &object, const Technique &technique) {
    return technique.frequency == Frequency::hybrid ? has_specular(scene, object, technique)
                                                    : reads_normals(scene, object, technique);
}

bool reads_positions(const Scene &scene, const Object &object, const Technique &technique) {
    const bool where_lit = technique.ambient == AmbientWhere::where_lit;
    const bool places_lights = any_light(scene, object, technique, [&](const Light &light, const ShiningTerms &terms) {
        return has_position(light) && (terms.diffuse || terms.specular ||
                                       (terms.ambient && (where_lit || (light.attenuate_ambient && fades(light)))));
    });
    return places_lights || (technique.viewer == Viewer::local && reads_view(scene, object, technique));
}

bool reads_translation(const Scene &scene, const Object &object, const Technique &technique) {
    return object.transform.translate != glm::dvec3(0) && reads_positions(scene, object, technique);
}

bool attenuates_per_pixel(const Scene &scene, const Object &object, const Technique &technique) {
    const bool all_terms = technique.frequency != Frequency::hybrid;
    return any_light(scene, object, technique, [&](const Light &light, const ShiningTerms &terms) {
        const bool by_distance =
            has_position(light) && (light.attenuation.linear != 0 || light.attenuation.quadratic != 0);
        const bool attenuated =
            terms.specular || (all_terms && (terms.diffuse || (terms.ambient && light.attenuate_ambient)));
        return by_distance && attenuated;
    });
}

bool raises_large_exponents(const Scene &scene, const Object &object, const Technique &technique) {
    return raises(scene, object, technique, [](double n) { return n >= stable_power_from; });
}

bool raises_small_exponents(const Scene &scene, const Object &object, const Technique &technique) {
    return raises(scene, object, technique, [](double n) { return n > 0 && n < stable_power_from; });
}

} // namespace sandbox::rules

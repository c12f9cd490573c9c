#include "reference/lighting.h"

#include "scene/light_kind.h"
#include "scene/space.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

namespace sandbox::reference {

namespace {

constexpr double attenuation_floor = 1e-6;

/// 1 - cos, which keeps its digits where the cosine is 1.
double versine(double degrees) { return 2 * std::pow(std::sin(glm::radians(degrees) / 2), 2); }

/// smoothstep(cos outer, cos inner, c) from 1 - cos of all three: cones of 1e-5 degrees have edges, too.
double soft_edge(const LightSetup &light, const glm::dvec3 &l) {
    const glm::dvec3 chord = -l - light.travel; // half its square is 1 - c
    const double outer = versine(light.light.cutoff_degrees);
    const double width = outer - versine(light.light.inner_cutoff_degrees);
    const double inside = outer - glm::dot(chord, chord) / 2;
    const double t = width > 0 ? std::clamp(inside / width, 0.0, 1.0) : (inside < 0 ? 0.0 : 1.0);
    return t * t * (3 - 2 * t);
}

LightSetup prepare_light(const Light &light, const Technique &technique, const glm::dvec3 &eye,
                         const glm::dvec3 &view_axis) {
    LightSetup setup;
    setup.light = light;
    const bool absolute = technique.position == LightingPosition::absolute;
    setup.position = absolute ? as_float(light.position) - as_float(eye) : light.position - eye;
    setup.travel = unit(light.direction);
    setup.cone = has_cone(light);
    setup.cos_outer = cos_degrees(light.cutoff_degrees);
    setup.cos_inner = cos_degrees(light.inner_cutoff_degrees);
    const glm::dvec3 to_light = has_position(light) ? unit(light.position) : -setup.travel;
    setup.constant_half = unit(to_light + view_axis);
    return setup;
}

/// c, s and s_uncut of a spot; the exponent counts only inside a cone (cutoff 180 drops it, as OpenGL did).
void spot_factor(const LightSetup &light, LightTerms &terms) {
    if (!kind_of(light.light.type).conical) {
        return;
    }
    terms.c = glm::dot(-terms.vectors.l, light.travel);
    if (!light.cone) {
        return;
    }
    terms.s_uncut = power_of_dot(-terms.vectors.l, light.travel, light.light.exponent);
    terms.s = terms.c < light.cos_outer ? 0 : terms.s_uncut;
    if (light.light.inner_cutoff_degrees < light.light.cutoff_degrees && terms.s != 0) {
        terms.s *= soft_edge(light, terms.vectors.l);
    }
}

bool gate_open(Gate gate, double n_dot_l, const glm::dvec3 &n, const glm::dvec3 &v) {
    switch (gate) {
    case Gate::light_facing:
    case Gate::times_n_dot_l:
        return n_dot_l > 0;
    case Gate::view_facing:
        return glm::dot(n, v) > 0;
    case Gate::none:
        return true;
    }
    return true;
}

void specular_factor(const Setup &setup, const glm::dvec3 &n, const glm::dvec3 &v, double shininess,
                     LightTerms &terms) {
    const auto [a, b] = highlight_vectors(setup.technique.model, terms.vectors, n, v);
    terms.exponent = raised_exponent(setup, shininess);
    terms.f = std::max(glm::dot(a, b), 0.0);
    terms.f_power = power_of_dot(a, b, terms.exponent);
    terms.gate = gate_open(setup.technique.gate, terms.n_dot_l, n, v);
}

} // namespace

glm::dvec3 as_float(const glm::dvec3 &v) {
    const auto rounded = [](double value) {
        const volatile float single = static_cast<float>(value); // GCC 12 drops a way to float and back at -O2
        return double{single};
    };
    return {rounded(v.x), rounded(v.y), rounded(v.z)};
}

double power_of_dot(const glm::dvec3 &a, const glm::dvec3 &b, double n) {
    if (n == 0) {
        return 1;
    }
    const double lengths = std::sqrt(glm::dot(a, a)) * std::sqrt(glm::dot(b, b));
    const glm::dvec3 u = unit(a);
    const glm::dvec3 w = unit(b);
    const double cosine = glm::dot(u, w);
    if (!(cosine > 0)) {
        return 0;
    }
    const glm::dvec3 gap = u - w;
    double logarithm = cosine > 0.5 ? std::log1p(-glm::dot(gap, gap) / 2) : std::log(cosine);
    // Lengths that differ from 1 by rounding alone must not be raised to n.
    if (std::abs(lengths - 1) > 1e-15) {
        logarithm += std::log(lengths);
    }
    return std::exp(n * logarithm);
}

double attenuation(const Attenuation &k, double d) {
    return 1 / std::max(k.constant + (k.linear + k.quadratic * d) * d, attenuation_floor);
}

Setup prepare(const Scene &scene, const Technique &technique) {
    Setup setup;
    setup.technique = technique;
    setup.eye = scene.camera.position;
    setup.view_axis = -camera_axes(scene.camera).forward;
    setup.to_view = world_to_view_axes(scene.camera);
    setup.origin = technique.position == LightingPosition::absolute ? -setup.eye : glm::dvec3(0);
    setup.orthographic = is_orthographic(scene.camera);
    setup.ambient = scene.ambient;
    setup.blinn_exponent_scale = scene.blinn_exponent_scale;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        if (scene.lights[i].enabled) {
            setup.lights.push_back(prepare_light(scene.lights[i], technique, setup.eye, setup.view_axis));
            setup.light_index.push_back(i);
        }
    }
    return setup;
}

glm::dvec3 view_vector(const Setup &setup, const glm::dvec3 &p) {
    return setup.orthographic || setup.technique.viewer == Viewer::infinite ? setup.view_axis : unit(-p);
}

LightVectors light_vectors(const Setup &setup, const LightSetup &light, const glm::dvec3 &p, const glm::dvec3 &n,
                           const glm::dvec3 &v) {
    LightVectors vectors;
    if (!has_position(light.light)) {
        vectors.l = -light.travel;
    } else {
        const glm::dvec3 to_light = light.position - p;
        vectors.d = glm::length(to_light);
        vectors.l = vectors.d == 0 ? n : unit(to_light);
        vectors.a = attenuation(light.light.attenuation, vectors.d);
    }
    switch (setup.technique.model) {
    case Model::lambert:
    case Model::own:
        break;
    case Model::phong:
        vectors.r = 2 * glm::dot(n, vectors.l) * n - vectors.l;
        break;
    case Model::blinn_phong:
        vectors.h = setup.technique.half_vector == HalfVector::constant ? light.constant_half : unit(vectors.l + v);
        vectors.h = vectors.h == glm::dvec3(0) ? n : vectors.h;
        break;
    }
    return vectors;
}

std::pair<glm::dvec3, glm::dvec3> highlight_vectors(Model model, const LightVectors &vectors, const glm::dvec3 &n,
                                                    const glm::dvec3 &v) {
    switch (model) {
    case Model::lambert:
    case Model::own:
        break;
    case Model::phong:
        return {vectors.r, v};
    case Model::blinn_phong:
        return {n, vectors.h};
    }
    return {};
}

double raised_exponent(const Setup &setup, double shininess) {
    return reflection(setup.technique.model).scaled_exponent ? setup.blinn_exponent_scale * shininess : shininess;
}

double highlight_scale(const Setup &setup, double shininess) {
    return setup.technique.normalisation == Normalisation::blinn_phong
               ? (raised_exponent(setup, shininess) + 8) / (8 * std::numbers::pi)
               : 1;
}

LightTerms light_terms(const Setup &setup, const LightSetup &light, const LightVectors &vectors, const glm::dvec3 &n,
                       const glm::dvec3 &v, double shininess) {
    const Technique &technique = setup.technique;
    LightTerms terms;
    terms.vectors = vectors;
    terms.n_dot_l = glm::dot(n, vectors.l);
    spot_factor(light, terms);
    const double reach = vectors.a * terms.s;

    if (technique.ambient == AmbientWhere::everywhere || terms.n_dot_l > 0) {
        terms.ambient = light.light.color * light.light.ambient * (light.light.attenuate_ambient ? reach : 1);
    }
    const bool normalised = technique.normalisation == Normalisation::blinn_phong;
    const bool unnegated = technique.direction == DirectionSign::unnegated_diffuse && !has_position(light.light);
    const double incidence = unnegated ? glm::dot(n, light.travel) : terms.n_dot_l;
    terms.diffuse = light.light.color *
                    (light.light.diffuse * std::max(incidence, 0.0) * reach * (normalised ? std::numbers::inv_pi : 1));
    if (reflection(technique.model).specular) {
        specular_factor(setup, n, v, shininess, terms);
        const double factor =
            (technique.gate == Gate::times_n_dot_l ? terms.n_dot_l : 1) * highlight_scale(setup, shininess);
        terms.specular = light.light.color * (terms.gate ? light.light.specular * terms.f_power * reach * factor : 0);
    }
    return terms;
}

glm::dvec3 compose(const Material &material, const glm::dvec3 &base, const Reflected &reflected) {
    const glm::dvec3 tint = material.texture_modulates_specular ? base : glm::dvec3(1);
    return material.emission + base * reflected.body + tint * reflected.highlight;
}

glm::dvec3 facing(const Setup &setup, bool two_sided, const glm::dvec3 &n, const glm::dvec3 &v, Side side) {
    const bool away = setup.technique.facing == Facing::view ? glm::dot(n, v) < 0 : side == Side::back;
    return two_sided && away ? -n : n;
}

} // namespace sandbox::reference

#include "shading/features.h"

#include "scene/space.h"
#include "shading/light_place.h"
#include "shading/needs.h"
#include "shading/own_interface.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

namespace sandbox {
namespace {

bool any(const glm::dvec3 &v) { return v != glm::dvec3(0); }

void add_light(LightFeatures &f, const ObjectLight &on_object, const Light &light, const Technique &technique) {
    f.count += 1;
    f.ambient |= on_object.ambient;
    f.attenuated_ambient |= on_object.attenuated_ambient;
    f.diffuse |= on_object.diffuse;
    f.specular |= on_object.specular;
    if (has_position(light) && light.attenuation != Attenuation{}) {
        f.constant |= light.attenuation.constant != 0;
        f.linear |= light.attenuation.linear != 0;
        f.quadratic |= light.attenuation.quadratic != 0;
    }
    if (!has_cone(light)) {
        return;
    }
    (has_soft_edge(light) ? f.soft_cone : f.hard_cone) = true;
    f.narrow_cone |= is_narrow_cone(light);
    (light.exponent != 0 ? f.exponent : f.no_exponent) = true;
    f.stable_exponent |= asks_for_stable_power(technique, light.exponent);
}

LightFeatures light_features(const std::vector<ObjectLight> &lights, const Scene &scene, const Technique &technique,
                             const Object &object, const Mesh &mesh) {
    LightFeatures f;
    for (const ObjectLight &on_object : lights) {
        const Light &light = scene.lights[on_object.index];
        add_light(f, on_object, light, technique);
        f.on_surface |= has_position(light) && may_touch(light, object, mesh);
        f.opposite |= on_object.specular && reflection(technique.model).half_vector &&
                      may_oppose(light, scene, technique, object, mesh);
    }
    // One light that fades by distance brings all of its kind into the formula, with their own constant.
    const auto any_constant = [&](auto &&is) {
        return std::ranges::any_of(
            lights, [&](const ObjectLight &light) { return is(scene.lights[light.index].attenuation.constant); });
    };
    f.constant = f.attenuated() && any_constant([](double constant) { return constant != 0; });
    if (technique.power == Power::naive) { // no case of its own for what pow() or normalize() leave undefined
        f.exponent = f.cone();
        f.no_exponent = f.on_surface = false;
    }
    f.floor = f.attenuated() && any_constant([](double constant) { return constant < 1e-6; });
    f.no_exponent = f.no_exponent && f.exponent;
    f.stable_exponent = f.stable_exponent && f.exponent;
    return f;
}

/// Is some ambient term evaluated with its light?
bool lit_ambient(const Features &f) {
    return std::ranges::any_of(f.lights,
                               [](const LightFeatures &light) { return light.ambient || light.attenuated_ambient; });
}

/// The faults that nobody could see are left out: of a uniform scale, and of no transform at all.
void derive_normal_transform(Features &f, Normals normals, const glm::dmat3 &linear, const EyeSpace &space) {
    if (normals == Normals::unnormalized || normals == Normals::cofactor || normals == Normals::view_space) {
        f.technique.normals = normals;
        f.normal_transform = NormalTransform::general;
        return;
    }
    const bool uniform = scales_evenly(linear);
    if (uniform && linear == glm::dmat3(linear[0][0]) && linear[0][0] > 0) {
        return;
    }
    if (normals == Normals::untransformed) {
        f.technique.normals = normals;
    } else if (uniform && space.scale == 1 && space.lit_scale == 1 &&
               std::abs(std::abs(glm::determinant(linear)) - 1) <= 1e-12) {
        f.normal_transform = NormalTransform::rigid;
    } else {
        f.normal_transform = NormalTransform::general;
        f.technique.normals = uniform ? Normals::inverse_transpose : normals;
    }
}

/// How short or long may a unit normal become, by the columns of its matrix (which are orthogonal before they are
/// turned)? Singular matrices leave nothing of some.
bool may_lose_normals(const Features &f, const EyeSpace &space) {
    if (f.normal_transform != NormalTransform::general || f.technique.normals == Normals::unnormalized) {
        return false;
    }
    const glm::dmat3 m = f.technique.normals == Normals::model_matrix ? glm::dmat3(space.model) : space.normals;
    const auto [least, most] = std::minmax({glm::length(m[0]), glm::length(m[1]), glm::length(m[2])});
    return least < 1e-7 || most > 1e16;
}

void derive_normals(Features &f, const Technique &technique, const Object &object, const Mesh &mesh,
                    const EyeSpace &space) {
    const Normals normals = f.technique.normals;
    f.technique.normals = Normals::inverse_transpose;
    f.technique.renormalize = Renormalize::on;
    f.two_sided = f.normals && object.two_sided;
    f.technique.facing = f.two_sided ? technique.facing : Facing::winding;
    if (!f.normals) {
        return;
    }
    derive_normal_transform(f, normals, linear_part(object.transform), space);
    const bool naive = technique.power == Power::naive;
    f.guard_vertex_normal = !naive && may_lose_normals(f, space);
    const bool interpolated = f.technique.frequency == Frequency::per_pixel ||
                              f.technique.frequency == Frequency::interpolated_vectors ||
                              (f.technique.frequency == Frequency::hybrid && f.specular());
    if (interpolated) {
        f.technique.renormalize = technique.renormalize;
        // A flattened object's normals are all but opposite on the two sides of its rim.
        f.guard_normal = !naive && technique.renormalize == Renormalize::on && normals != Normals::unnormalized &&
                         (mesh.opposing_normals || f.guard_vertex_normal);
    }
}

void derive_surface(Features &f, const Technique &technique, const Material &material, const Mesh &mesh) {
    const bool lit_base =
        f.ambient || lit_ambient(f) || f.diffuse() || (f.specular() && material.texture_modulates_specular);
    f.chequered = lit_base && material.checker;
    f.textured = lit_base && !material.checker && !material.texture.empty();
    f.colored = lit_base && !mesh.colors.empty();
    const bool emits = any(material.emission);
    f.emission = emits && f.has_base();
    f.ambient |= emits && !f.has_base();
    f.base_times_specular = f.has_base() && f.specular() && material.texture_modulates_specular;
    f.technique.ambient = lit_ambient(f) ? technique.ambient : AmbientWhere::everywhere;
    f.normals = f.diffuse() || f.specular() || f.technique.ambient == AmbientWhere::where_lit;
}

void derive_highlights(Features &f, const Scene &scene, const Technique &technique, const Material &material) {
    f.technique.half_vector = HalfVector::exact; // what of these shows, given_half_vector and exponent say
    f.technique.power = technique.power == Power::naive ? f.technique.power : Power::automatic;
    if (!f.specular()) {
        f.technique.model = Model::lambert;
        f.technique.gate = Gate::light_facing;
        for (LightFeatures &light : f.lights) {
            light.opposite = false;
        }
        return;
    }
    f.exponent = exponent_kind(technique, f.technique.normals, raised_exponent(scene, technique.model, material));
    for (const LightKind &kind : light_kinds) {
        LightFeatures &light = f.lights[kind.type];
        const bool same_everywhere =
            technique.half_vector == HalfVector::constant || (!kind.positional && technique.viewer == Viewer::infinite);
        light.given_half_vector = light.specular && f.uses_half_vector() && same_everywhere;
        const bool interpolated = technique.frequency == Frequency::interpolated_vectors; // may cancel
        light.opposite = f.exponent != Exponent::zero && technique.power != Power::naive && light.specular &&
                         f.uses_half_vector() && (light.opposite || light.given_half_vector || interpolated);
    }
}

/// n as a whole number of multiplications, whose error (n - 1) 2^-24 is below what pow() is allowed; 0: by pow().
int whole_exponent(const Features &f, const Technique &technique, double n) {
    const bool by_pow = f.exponent == Exponent::textbook && technique.power != Power::naive;
    const bool whole = n >= 2 && n < stable_power_from && n == std::floor(n);
    return by_pow && whole ? static_cast<int>(n) : 0;
}

/// Does the equation read V? What does not is the same program whatever the viewer and the position key say.
bool needs_view(const Features &f) {
    const bool open_half = std::ranges::any_of(
        f.lights, [](const LightFeatures &light) { return light.specular && !light.given_half_vector; });
    const bool reflects = f.exponent != Exponent::zero && (f.mirrors_view() || (f.uses_half_vector() && open_half));
    return f.normals && (f.turns_by_view() || (f.specular() && (reflects || f.technique.gate == Gate::view_facing)));
}

/// Is anything of the lights interpolated, or V? A directional light's constant L and H are not.
bool interpolates_vectors(const Features &f) {
    const StageNeeds fragment = derive_needs(f).fragment;
    return std::ranges::any_of(fragment.lights, &LightNeeds::given_any) ||
           (fragment.V && f.technique.viewer == Viewer::local);
}

/// A frequency or fault that cannot show is replaced by the plain one, so that equal programs have equal features.
void derive_what_shows(Features &f, const Technique &technique) {
    Technique &shown = f.technique;
    shown.viewer = Viewer::local;
    shown.position = LightingPosition::world;
    shown.attenuation = AttenuationAt::exact;
    shown.direction = DirectionSign::travel;
    if (std::ranges::none_of(f.lights, &LightFeatures::count)) {
        shown.frequency = Frequency::per_pixel;
        return;
    }
    if (shown.frequency == Frequency::hybrid && !f.specular()) {
        shown.frequency = Frequency::per_vertex;
    }
    if (shown.frequency == Frequency::hybrid && !f.diffuse() && !lit_ambient(f)) {
        shown.frequency = Frequency::per_pixel; // no light is left for the vertices
    }
    bool positional = false;
    for (const LightKind &kind : light_kinds) {
        const LightFeatures &light = f.lights[kind.type];
        positional |= kind.positional && light.count > 0;
        if (light.attenuated()) {
            shown.attenuation = technique.attenuation;
        }
        if (!kind.positional && light.diffuse) {
            shown.direction = technique.direction;
        }
    }
    if (needs_view(f)) {
        shown.viewer = technique.viewer;
    }
    if (positional || (needs_view(f) && shown.viewer == Viewer::local)) {
        shown.position = technique.position;
    }
    if (shown.frequency == Frequency::interpolated_vectors && !interpolates_vectors(f)) {
        shown.frequency = Frequency::per_pixel;
    }
}

/// Where both terms are added to one sum, one number can stand for the second colour. What all lights of a kind share
/// is one uniform.
void derive_what_is_one(Features &f, const Scene &scene, const Material &material, const ObjectLights &lights) {
    const Technique &shown = f.technique;
    const bool one_sum = shown.frequency != Frequency::hybrid && (!f.has_base() || f.base_times_specular);
    const bool rounds_in_order = shown.precision == Precision::medium;
    const auto has_one_color = [&](const ObjectLight &on_object) {
        const Light &light = scene.lights[on_object.index];
        const glm::dvec3 diffuse = material.diffuse * light.color, specular = material.specular * light.color;
        constexpr double rounding = 1e-12;
        return on_object.diffuse_factor * light.diffuse > 0 && on_object.specular && any(diffuse) &&
               glm::length(glm::cross(diffuse, specular)) <= rounding * glm::length(diffuse) * glm::length(specular);
    };
    for (const LightKind &kind : light_kinds) {
        LightFeatures &light = f.lights[kind.type];
        light.one_color = one_sum && !rounds_in_order && light.diffuse && light.specular &&
                          std::ranges::all_of(lights.of_kind[kind.type], has_one_color);
        const std::vector<ObjectLight> &all = lights.of_kind[kind.type];
        const auto as_the_first = [&](const auto &same) {
            return all.size() > 1 && !rounds_in_order && std::ranges::all_of(all, [&](const ObjectLight &one) {
                       return same(one, scene.lights[one.index], all[0], scene.lights[all[0].index]);
                   });
        };
        light.one_share = light.one_color && as_the_first([&](const ObjectLight &use, const Light &given,
                                                              const ObjectLight &first_use, const Light &first) {
                              const double share = specular_share(material, given, use),
                                           its = specular_share(material, first, first_use);
                              return std::abs(share - its) <= 1e-12 * its;
                          });
        light.one_attenuation = light.attenuated() &&
                                as_the_first([](const ObjectLight &, const Light &given, const ObjectLight &,
                                                const Light &first) { return given.attenuation == first.attenuation; });
    }
}

/// By the rules of the rows, which say what no picture shows. Below, the keys that the program's text depends on are
/// decided more exactly, by what the program reads.
Technique without_effectless_values(Technique technique, const Scene &scene, const Object &object) {
    const Technique given = technique;
    for (const TechniqueKey &key : technique_settings) {
        const auto can_matter = key.value(given).can_matter;
        if (can_matter != nullptr && !can_matter(scene, object, given)) {
            key.set(technique, 0);
        }
    }
    return technique;
}

/// The text decides all but how it is fed.
Features own_features(const Scene &scene, const Technique &technique, const Object &object, const Mesh &mesh,
                      const EyeSpace &space) {
    const OwnText &text = *technique.own;
    Features f;
    f.technique = {.frequency = technique.frequency, .model = Model::own, .own = technique.own};
    f.own.lights = static_cast<int>(own_lights(scene).size());
    f.own.moved = text.position && space.origin != glm::dvec3(0);
    f.chequered = text.base && object.material.checker;
    f.textured = text.base && !object.material.checker && !object.material.texture.empty();
    f.colored = text.base && !mesh.colors.empty();
    f.normals = text.reads_N;
    f.two_sided = f.normals && object.two_sided;
    if (f.normals && !text.normal) {
        derive_normal_transform(f, Normals::inverse_transpose, linear_part(object.transform), space);
        f.guard_vertex_normal = may_lose_normals(f, space);
    }
    return f;
}

} // namespace

double raised_exponent(const Scene &scene, Model model, const Material &material) {
    return (reflection(model).scaled_exponent ? scene.blinn_exponent_scale : 1) * material.shininess;
}

bool asks_for_stable_power(const Technique &technique, double n) {
    return technique.power == Power::stable || (technique.power == Power::automatic && n >= stable_power_from);
}

Exponent exponent_kind(const Technique &technique, Normals normals, double n) {
    // The stable form measures an angle between unit vectors. Interpolated R and V are made unit whatever N is.
    const bool can_be_stable =
        normals != Normals::unnormalized &&
        (technique.renormalize == Renormalize::on ||
         (mirrors_view(technique.model) && technique.frequency == Frequency::interpolated_vectors));
    if (technique.power == Power::naive) {
        return Exponent::textbook;
    }
    if (n == 0 || n == 1) {
        return n == 0 ? Exponent::zero : Exponent::one;
    }
    if (asks_for_stable_power(technique, n)) {
        return can_be_stable ? Exponent::stable : Exponent::textbook;
    }
    return Exponent::textbook;
}

Features derive_features(const Scene &scene, const Technique &given, const Object &object, const Mesh &mesh,
                         const ObjectLights &lights, const EyeSpace &space) {
    if (given.model == Model::own) {
        return own_features(scene, given, object, mesh, space);
    }
    Technique technique = given;
    const bool orthographic = is_orthographic(scene.camera);
    if (orthographic) {
        technique.viewer = Viewer::infinite;
    }
    Features f;
    f.technique = without_effectless_values(technique, scene, object);
    f.technique.program = Program::specialised; // till the end: see mirrors_view()
    for (const LightKind &kind : light_kinds) {
        f.lights[kind.type] = light_features(lights.of_kind[kind.type], scene, technique, object, mesh);
    }
    f.ambient = any(lights.constant_ambient);
    derive_surface(f, technique, object.material, mesh);
    derive_highlights(f, scene, technique, object.material);
    derive_normals(f, technique, object, mesh, space);
    derive_what_shows(f, technique);
    derive_what_is_one(f, scene, object.material, lights);
    const bool lights_pixels = technique.frequency == Frequency::per_pixel || technique.frequency == Frequency::hybrid;
    f.wide = lights_pixels && technique.position == LightingPosition::world && is_wide(scene, object, mesh);
    if (technique.program == Program::baked) {
        f.technique.program = Program::baked;
        f.whole_exponent = whole_exponent(f, technique, raised_exponent(scene, technique.model, object.material));
    }
    if (technique.program == Program::full) {
        f.technique.program = Program::full;
        f.technique.frequency = technique.frequency;
        f.afar = space.afar;
    } else {
        const ProgramNeeds needs = derive_needs(f);
        f.wide = f.wide && needs.fragment.P;
        f.afar = space.afar && needs.vertex.P;
    }
    f.orthographic = orthographic && f.technique.viewer == Viewer::infinite;
    return f;
}

int full_program_capacity(Frequency frequency, bool colored) {
    // interpolated-vectors: 7 components a light, and 11 besides, or 14
    return frequency != Frequency::interpolated_vectors ? 64 : colored ? 6 : 7;
}

LightFeatures every_light_feature(const LightKind &kind, const Features &program) {
    LightFeatures all;
    all.count = full_program_capacity(program.technique.frequency, program.colored);
    all.ambient = all.diffuse = all.specular = true;
    all.attenuated_ambient = kind.positional || kind.conical;
    all.constant = all.linear = all.quadratic = all.floor = all.on_surface = kind.positional;
    all.opposite = true;
    all.narrow_cone = all.hard_cone = all.soft_cone = kind.conical;
    all.exponent = all.no_exponent = all.stable_exponent = kind.conical;
    return all;
}

Features program_features(const Features &object) {
    if (!object.is_full()) {
        return object;
    }
    Features all;
    all.technique.program = Program::full;
    all.technique.frequency = object.technique.frequency;
    all.colored = object.colored;
    for (const LightKind &kind : light_kinds) {
        all.lights[kind.type] = every_light_feature(kind, all);
    }
    all.ambient = all.emission = all.textured = all.chequered = true;
    all.normals = all.guard_normal = all.guard_vertex_normal = all.two_sided = true;
    all.normal_transform = NormalTransform::general;
    all.exponent = Exponent::stable;
    all.wide = object.wide;
    all.deep = object.deep;
    all.invariant = object.invariant;
    all.object_ids = object.object_ids;
    all.shown = object.shown;
    all.srgb = object.srgb;
    all.exposed = object.exposed;
    return all;
}

Features without_guards(Features f) {
    for (LightFeatures &light : f.lights) {
        light.floor = light.on_surface = light.narrow_cone = light.stable_exponent = false;
    }
    f.exponent = f.exponent == Exponent::stable ? Exponent::textbook : f.exponent;
    f.guard_normal = f.guard_vertex_normal = f.afar = f.wide = f.deep = false;
    return f;
}

} // namespace sandbox

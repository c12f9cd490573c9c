#include "shading/features.h"

#include "image/error.h"
#include "scene/space.h"
#include "shading/length_scale.h"
#include "shading/needs.h"
#include "shading/normal_matrix.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

namespace sandbox {
namespace {

bool any(const glm::dvec3 &v) { return v != glm::dvec3(0); }

bool has_cone(const Light &light) { return light.type == LightType::spot && light.cutoff_degrees != 180; }
bool is_positional(const Light &light) { return light.type != LightType::directional; }

/// The light's terms that are not 0 on this object.
struct Terms {
    bool ambient, diffuse, specular;
};
Terms terms_of(const Light &light, const Technique &technique, const Material &material) {
    const bool shines = light.enabled && any(light.color);
    const auto meets = [&](const glm::dvec3 &color) { return shines && any(light.color * color); };
    return {meets(material.ambient) && light.ambient != 0, meets(material.diffuse) && light.diffuse != 0,
            meets(material.specular) && light.specular != 0 && technique.model != Model::lambert};
}

/// Could the light lie on the object? Its position against the mesh's bounds, in object space, with some room.
bool may_touch(const Light &light, const Object &object, const Mesh &mesh) {
    const glm::dmat3 linear = linear_part(object.transform);
    if (std::abs(glm::determinant(linear)) == 0) {
        return true;
    }
    const Bounds &bounds = mesh.bounds;
    const glm::dvec3 extent = bounds.high - bounds.low;
    const glm::dvec3 room = 0.01 * extent + glm::dvec3(1e-3 * glm::length(extent)); // flat shapes have some too
    const glm::dvec3 p = glm::inverse(linear) * (light.position - object.transform.translate);
    return glm::all(glm::greaterThanEqual(p, bounds.low - room)) && glm::all(glm::lessThanEqual(p, bounds.high + room));
}

Exponent exponent_kind(const Technique &technique, double n) {
    // The stable form measures an angle between unit vectors. Interpolated R and V are made unit whatever N is.
    const bool can_be_stable =
        technique.renormalize == Renormalize::on ||
        (technique.model == Model::phong && technique.frequency == Frequency::interpolated_vectors);
    if (n == 0 || n == 1) {
        return n == 0 ? Exponent::zero : Exponent::one;
    }
    if (technique.power == Power::stable || (technique.power == Power::automatic && n >= stable_power_from)) {
        return can_be_stable ? Exponent::stable : Exponent::textbook;
    }
    return Exponent::textbook;
}

/// A float32 cosine errs by 6e-8: by more than 1e-4 of an edge or a cone this narrow.
bool is_narrow(const Light &light) {
    const double outer = std::cos(glm::radians(light.cutoff_degrees));
    const double inner = std::cos(glm::radians(light.inner_cutoff_degrees));
    return 1 - outer < 6e-4 || (light.inner_cutoff_degrees < light.cutoff_degrees && inner - outer < 6e-4);
}

void add_light(LightFeatures &f, const Light &light, const Technique &technique, const Material &material) {
    const Terms terms = terms_of(light, technique, material);
    f.count += 1;
    if (terms.ambient && ambient_with_light(light, technique)) {
        (light.attenuate_ambient && fades(light) ? f.attenuated_ambient : f.ambient) = true;
    }
    f.diffuse |= terms.diffuse;
    f.specular |= terms.specular;
    if (is_positional(light) && light.attenuation != Attenuation{}) {
        f.constant |= light.attenuation.constant != 0;
        f.linear |= light.attenuation.linear != 0;
        f.quadratic |= light.attenuation.quadratic != 0;
    }
    if (!has_cone(light)) {
        return;
    }
    (light.inner_cutoff_degrees < light.cutoff_degrees ? f.soft_cone : f.hard_cone) = true;
    f.narrow_cone |= is_narrow(light);
    (light.exponent != 0 ? f.exponent : f.no_exponent) = true;
    f.stable_exponent |= technique.power == Power::stable ||
                         (technique.power == Power::automatic && light.exponent >= stable_power_from);
}

LightFeatures light_features(const std::vector<std::size_t> &indices, const Scene &scene, const Technique &technique,
                             const Object &object, const Mesh &mesh) {
    LightFeatures f;
    for (const std::size_t i : indices) {
        const Light &light = scene.lights[i];
        add_light(f, light, technique, object.material);
        f.on_surface |= is_positional(light) && may_touch(light, object, mesh);
    }
    // One light that fades by distance brings all of its type into the formula, with their own constant.
    f.constant = f.attenuated() &&
                 std::ranges::any_of(indices, [&](std::size_t i) { return scene.lights[i].attenuation.constant != 0; });
    f.floor = f.attenuated() &&
              std::ranges::any_of(indices, [&](std::size_t i) { return scene.lights[i].attenuation.constant < 1e-6; });
    f.no_exponent = f.no_exponent && f.exponent;
    f.stable_exponent = f.stable_exponent && f.exponent;
    return f;
}

bool constant_ambient(const Scene &scene, const Technique &technique, const Material &material) {
    return any(material.ambient * scene.ambient) || std::ranges::any_of(scene.lights, [&](const Light &light) {
               return terms_of(light, technique, material).ambient && !ambient_with_light(light, technique);
           });
}

/// Is some ambient term evaluated with its light?
bool lit_ambient(const Features &f) {
    const auto any_of = [](const LightFeatures &light) { return light.ambient || light.attenuated_ambient; };
    return any_of(f.directional) || any_of(f.point) || any_of(f.spot);
}

/// How short or long may a unit normal become, by the columns of its matrix (which are orthogonal before they are
/// turned)? Singular matrices leave nothing of some.
bool may_lose_normals(NormalTransform transform, const glm::dmat3 &linear) {
    if (transform != NormalTransform::normal_matrix && transform != NormalTransform::model_matrix) {
        return false;
    }
    const glm::dmat3 m = transform == NormalTransform::normal_matrix ? normal_matrix(linear) : linear;
    const auto [least, most] = std::minmax({glm::length(m[0]), glm::length(m[1]), glm::length(m[2])});
    return least < 1e-7 || most > 1e16;
}

void derive_surface(Features &f, const Scene &scene, const Technique &technique, const Object &object,
                    const Mesh &mesh) {
    const Material &material = object.material;
    f.ambient = constant_ambient(scene, technique, material);
    f.base = material.checker ? Base::checker : (material.texture.empty() ? Base::none : Base::texture);
    if (!f.ambient && !lit_ambient(f) && !f.diffuse() && !(f.specular() && material.texture_modulates_specular)) {
        f.base = Base::none;
    }
    const bool emits = any(material.emission);
    f.emission = emits && f.base != Base::none;
    f.ambient |= emits && f.base == Base::none;
    f.base_times_specular = f.base != Base::none && f.specular() && material.texture_modulates_specular;
    f.where_lit = technique.ambient == AmbientWhere::where_lit && lit_ambient(f);
    f.normals = f.diffuse() || f.specular() || f.where_lit;
    if (f.normals) {
        const double scale = length_scale(scene, object, mesh);
        f.normal_transform = scaled(normal_transform(technique, object), scale);
        f.guard_vertex_normal = may_lose_normals(f.normal_transform, linear_part(object.transform) * scale);
        f.two_sided = object.two_sided;
    }
    if (f.specular()) {
        f.exponent = exponent_kind(technique, raised_exponent(scene, technique.model, material));
        f.gate = technique.gate;
    }
    const bool interpolates_normal = f.frequency == Frequency::per_pixel ||
                                     f.frequency == Frequency::interpolated_vectors ||
                                     (f.frequency == Frequency::hybrid && f.specular());
    f.renormalize = f.normals && interpolates_normal && technique.renormalize == Renormalize::on;
    // A flattened object's normals are all but opposite on the two sides of its rim.
    f.guard_normal = f.renormalize && (mesh.opposing_normals || f.guard_vertex_normal);
}

void derive_half_vectors(Features &f, const Technique &technique) {
    const bool constant = technique.half_vector == HalfVector::constant;
    const auto given = [&](const LightFeatures &light) {
        return f.model == Model::blinn_phong && light.specular && constant;
    };
    f.directional.given_half_vector =
        given(f.directional) ||
        (f.model == Model::blinn_phong && f.directional.specular && technique.viewer == Viewer::infinite);
    f.point.given_half_vector = given(f.point);
    f.spot.given_half_vector = given(f.spot);
}

/// Does the equation read V, P? What does not is the same program whatever the viewer and the position key say.
bool needs_view(const Features &f) {
    const auto open_half = [](const LightFeatures &light) { return light.specular && !light.given_half_vector; };
    const bool reflects =
        f.exponent != Exponent::zero &&
        (f.model == Model::phong ||
         (f.model == Model::blinn_phong && (open_half(f.directional) || open_half(f.point) || open_half(f.spot))));
    return f.normals && (f.two_sided || (f.specular() && (reflects || f.gate == Gate::view_facing)));
}

/// Is anything of the lights interpolated, or V? A directional light's constant L and H are not.
bool interpolates_vectors(const Features &f) {
    const StageNeeds fragment = derive_needs(f).fragment;
    const auto handed = [](const LightNeeds &light) {
        return light.given_L || light.given_H || light.given_R || light.given_distance || light.given_attenuation;
    };
    return handed(fragment.directional) || handed(fragment.point) || handed(fragment.spot) ||
           (fragment.V && f.viewer == Viewer::local);
}

/// A frequency or fault that cannot show is replaced by the plain one, so that equal programs have equal features.
void simplify(Features &f, const Technique &technique) {
    const bool lights = f.directional.count + f.point.count + f.spot.count > 0;
    if (!lights) {
        f.frequency = Frequency::per_pixel;
        return;
    }
    if (f.frequency == Frequency::hybrid && !f.specular()) {
        f.frequency = Frequency::per_vertex;
    }
    if (f.frequency == Frequency::hybrid && !f.diffuse() && !lit_ambient(f)) {
        f.frequency = Frequency::per_pixel; // no light is left for the vertices
    }
    f.viewer = needs_view(f) ? technique.viewer : Viewer::local;
    const bool positional = f.point.count + f.spot.count > 0;
    if (positional || (needs_view(f) && f.viewer == Viewer::local)) {
        f.position = technique.position;
    }
    if (f.point.attenuated() || f.spot.attenuated()) {
        f.attenuation = technique.attenuation;
    }
    f.unnegated_diffuse = f.directional.diffuse && technique.direction == DirectionSign::unnegated_diffuse;
    if (f.frequency == Frequency::interpolated_vectors && !interpolates_vectors(f)) {
        f.frequency = Frequency::per_pixel;
    }
}

} // namespace

NormalTransform normal_transform(const Technique &technique, const Object &object) {
    const glm::dmat3 linear = linear_part(object.transform);
    const bool uniform = scales_evenly(linear);
    if (uniform && linear == glm::dmat3(linear[0][0]) && linear[0][0] > 0) {
        return NormalTransform::identity;
    }
    if (technique.normals == Normals::untransformed) {
        return NormalTransform::untransformed;
    }
    if (uniform && std::abs(std::abs(glm::determinant(linear)) - 1) <= 1e-12) {
        return NormalTransform::rigid;
    }
    const bool fault = technique.normals == Normals::model_matrix && !uniform;
    return fault ? NormalTransform::model_matrix : NormalTransform::normal_matrix;
}

NormalTransform scaled(NormalTransform transform, double length_scale) {
    return transform == NormalTransform::rigid && length_scale != 1 ? NormalTransform::normal_matrix : transform;
}

bool fades(const Light &light) {
    return (is_positional(light) && light.attenuation != Attenuation{}) || has_cone(light);
}

bool ambient_with_light(const Light &light, const Technique &technique) {
    return technique.ambient == AmbientWhere::where_lit || (light.attenuate_ambient && fades(light));
}

double raised_exponent(const Scene &scene, Model model, const Material &material) {
    return model == Model::blinn_phong ? scene.blinn_exponent_scale * material.shininess : material.shininess;
}

ContributingLights contributing_lights(const Scene &scene, const Technique &technique, const Object &object) {
    ContributingLights result;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const Light &light = scene.lights[i];
        const Terms terms = terms_of(light, technique, object.material);
        const bool ambient = terms.ambient && ambient_with_light(light, technique);
        if (!ambient && !terms.diffuse && !terms.specular) {
            continue;
        }
        auto &list = light.type == LightType::directional ? result.directional
                     : has_cone(light)                    ? result.spot
                                                          : result.point;
        list.push_back(i);
    }
    return result;
}

Features derive_features(const Scene &scene, const Technique &technique, const Object &object, const Mesh &mesh,
                         bool object_ids, bool deep) {
    Features f;
    f.object_ids = object_ids;
    f.deep = deep || is_deep(scene.camera);
    const bool lights_pixels = technique.frequency == Frequency::per_pixel || technique.frequency == Frequency::hybrid;
    f.wide = lights_pixels && technique.position == LightingPosition::world && is_wide(scene, object, mesh);
    f.frequency = technique.frequency;
    if (technique.program == Program::full) {
        f.program = Program::full;
        return f;
    }
    const ContributingLights lights = contributing_lights(scene, technique, object);
    f.directional = light_features(lights.directional, scene, technique, object, mesh);
    f.point = light_features(lights.point, scene, technique, object, mesh);
    f.spot = light_features(lights.spot, scene, technique, object, mesh);
    f.model = f.specular() ? technique.model : Model::lambert;
    derive_surface(f, scene, technique, object, mesh);
    derive_half_vectors(f, technique);
    simplify(f, technique);
    f.wide = f.wide && derive_needs(f).fragment.P;
    return f;
}

std::vector<Features> derive_features(const Scene &scene, const Technique &technique,
                                      const std::vector<ObjectResources> &resources) {
    const bool deep = is_deep(scene, resources);
    std::vector<Features> all;
    all.reserve(scene.objects.size());
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        all.push_back(derive_features(scene, technique, scene.objects[i], *resources[i].mesh, false, deep));
    }
    return all;
}

Features without_guards(Features f) {
    for (LightFeatures *light : {&f.directional, &f.point, &f.spot}) {
        light->floor = light->on_surface = light->narrow_cone = light->stable_exponent = false;
    }
    f.exponent = f.exponent == Exponent::stable ? Exponent::textbook : f.exponent;
    f.guard_normal = f.guard_vertex_normal = f.wide = f.deep = false;
    return f;
}

} // namespace sandbox

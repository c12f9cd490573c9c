#include "certificate/choice.h"

#include "certificate/light_groups.h"
#include "certificate/shading_bound.h"
#include "image/thread.h"
#include "scene/light_kind.h"
#include "scene/space.h"
#include "scene/unit.h"
#include "shading/eye_space.h"
#include "shading/features.h"
#include "shading/object_lights.h"

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

namespace sandbox::certificate {
namespace {

/// The largest colour, per channel, that a surface is multiplied by; infinite where some colour is below 0.
glm::dvec3 largest_base(const Object &object, const ObjectResources &own) {
    glm::dvec3 low{1}, high{1};
    if (object.material.checker) {
        low = glm::min(object.material.checker->colors[0], object.material.checker->colors[1]);
        high = glm::max(object.material.checker->colors[0], object.material.checker->colors[1]);
    } else if (own.texture != nullptr) {
        low = high = glm::dvec3(0);
        for (const glm::vec4 &texel : own.texture->pixels) {
            low = glm::min(low, glm::dvec3(texel));
            high = glm::max(high, glm::dvec3(texel));
        }
    }
    glm::dvec3 tint{own.mesh->colors.empty() ? 1.0 : 0.0};
    for (const glm::dvec3 &color : own.mesh->colors) {
        low = glm::min(low, color);
        tint = glm::max(tint, color);
    }
    constexpr double infinite = std::numeric_limits<double>::infinity();
    return std::min({low.x, low.y, low.z}) < 0 ? glm::dvec3(infinite) : high * tint;
}

BoundLight bound_light(const Light &light, const ObjectLight &use, const Technique &technique, const Camera &camera,
                       const Material &material, const glm::dvec3 &base) {
    BoundLight bound;
    bound.index = use.index;
    bound.positional = has_position(light);
    bound.cone = has_cone(light);
    bound.position = light.position - camera.position;
    bound.travel = unit_or(light.direction, glm::dvec3(0));
    bound.attenuation = light.attenuation;
    bound.cos_outer = cos_degrees(light.cutoff_degrees);
    bound.cos_inner = cos_degrees(light.inner_cutoff_degrees);
    bound.cone_exponent = light.exponent;
    bound.ambient_fades = light.attenuate_ambient;
    const glm::dvec3 view_axis = -camera_axes(camera).forward;
    const glm::dvec3 half = (bound.positional ? unit_or(light.position, glm::dvec3(0)) : -bound.travel) + view_axis;
    bound.half = glm::length(half) > 1e-6 ? glm::normalize(half) : glm::dvec3(0); // a shorter one is rounding
    bound.diffuse_sign = technique.direction == DirectionSign::unnegated_diffuse && !bound.positional ? -1 : 1;
    if (use.ambient || use.attenuated_ambient) {
        bound.ambient = light.ambient * light.color * material.ambient * base;
    }
    if (use.diffuse) {
        bound.diffuse = light.diffuse * use.diffuse_factor * light.color * material.diffuse * base;
    }
    if (use.specular) {
        bound.specular = light.specular * use.specular_factor * light.color * material.specular *
                         (material.texture_modulates_specular ? base : glm::dvec3(1));
    }
    return bound;
}

BoundObject bound_object(const Scene &scene, const Technique &technique, const Object &object,
                         const ObjectResources &own) {
    BoundObject bound;
    bound.technique = technique;
    bound.exponent = raised_exponent(scene, technique.model, object.material);
    if (is_orthographic(scene.camera) || technique.viewer == Viewer::infinite) {
        bound.view = -camera_axes(scene.camera).forward;
    }
    bound.unit_normals = technique.normals != Normals::unnormalized && technique.renormalize == Renormalize::on;
    bound.two_sided = object.two_sided;
    const bool has_base = object.material.checker || own.texture != nullptr || !own.mesh->colors.empty();
    bound.highlight_apart = has_base && !object.material.texture_modulates_specular;
    const glm::dvec3 base = largest_base(object, own);
    const ObjectLights lights = lights_on_object(scene, technique, object);
    const glm::dvec3 constant = lights.constant_ambient * base + object.material.emission;
    bound.constant = std::max({constant.x, constant.y, constant.z});
    for (const auto &of_kind : lights.of_kind) {
        for (const ObjectLight &use : of_kind) {
            bound.lights.push_back(
                bound_light(scene.lights[use.index], use, technique, scene.camera, object.material, base));
        }
    }
    return bound;
}

/// Vertices as they are lit: world axes, the eye as the origin.
struct LitVertices {
    std::vector<glm::dvec3> positions, normals;
};
LitVertices lit_vertices(const Scene &scene, const Technique &technique, const Object &object, const Mesh &mesh) {
    const glm::dmat3 linear = linear_part(object.transform);
    const glm::dvec3 offset =
        (technique.position == LightingPosition::w0 ? glm::dvec3(0) : object.transform.translate) -
        scene.camera.position;
    const bool unnormalized =
        technique.normals == Normals::unnormalized && glm::abs(object.transform.scale) != glm::dvec3(1);
    const glm::dmat3 normals = normal_matrix(
        unnormalized || technique.normals != Normals::unnormalized ? technique.normals : Normals::inverse_transpose,
        scene.camera, object, eye_space(scene, object, mesh, technique));
    LitVertices lit;
    lit.positions.reserve(mesh.positions.size());
    lit.normals.reserve(mesh.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        lit.positions.push_back(linear * mesh.positions[i] + offset);
        const glm::dvec3 normal = normals * mesh.normals[i];
        lit.normals.push_back(unnormalized ? normal : unit_or(normal, mesh.normals[i]));
    }
    return lit;
}

/// What float32 loses of a highlight's brightness, as shading-equations says of power=: measured, not proved.
double highlight_rounding(const Technique &technique, double n) {
    return 2e-5 + (exponent_kind(technique, technique.normals, n) == Exponent::stable ? 4e-8 : 4e-7) * n;
}
constexpr double body_rounding = 32 * 0x1p-24;

/// Clearly seen from behind: GPUs place vertices on a grid, which turns what is a tenth of a pixel wide by a twentieth.
bool shows_back(const Camera &camera, const Linear &corners, bool mirrored) {
    const glm::dvec3 face = glm::cross(corners[1] - corners[0], corners[2] - corners[0]) * (mirrored ? -1.0 : 1.0);
    const glm::dvec3 to_eye = is_orthographic(camera) ? -camera_axes(camera).forward : -corners[0];
    return glm::dot(face, to_eye) < -0.05 * glm::length(face) * glm::length(to_eye);
}

const char *why_nothing(const Technique &technique) {
    return technique.model == Model::own                      ? "own shading has no equation here"
           : technique.attenuation != AttenuationAt::exact    ? "interpolated attenuation is not bounded"
           : technique.precision != Precision::high           ? "half floats are not bounded"
           : technique.position == LightingPosition::absolute ? "float32 world positions are not bounded"
           : technique.power == Power::naive                  ? "power=naive is undefined in places"
                                                              : "";
}

/// Without the keys that no picture of the scene shows.
Technique as_it_shows(const Technique &given, const Scene &scene) {
    Technique technique = given;
    for (const TechniqueKey &key : technique_settings) {
        if (!can_matter(key, key.get(given), scene, given)) {
            key.set(technique, 0);
        }
    }
    return technique;
}

/// As seen from the eye, but for a factor: of a perspective camera its solid angle where it is small.
double seen_area(const Camera &camera, const Linear &corners) {
    const glm::dvec3 face = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    if (is_orthographic(camera)) {
        return std::abs(glm::dot(face, camera_axes(camera).forward));
    }
    const glm::dvec3 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
    return std::abs(glm::dot(face, middle)) / std::pow(std::max(glm::length(middle), 1e-100), 3);
}

/// Under half_vector=constant: may L = -V, where the equation takes N for H?
bool may_lose_half_vector(const BoundObject &object) {
    const Technique &technique = object.technique;
    return technique.half_vector == HalfVector::constant && reflection(technique.model).half_vector &&
           std::ranges::any_of(object.lights, [](const BoundLight &light) { return light.half == glm::dvec3(0); });
}

/// What is proved of an object.
struct Proof {
    ObjectChoice choice;
    double bound = 0;
    LightSet lights = 0;                      ///< of the object
    std::vector<LightSet> seen;               ///< one per triangle: no other light adds anything to it
    std::array<AreaOfLights, 2> area_of_seen; ///< in each of the two parts
};
constexpr std::uint8_t per_vertex = 0, per_pixel = 1; // its first two parts
Proof prove(const Scene &scene, const Technique &technique, const Object &object, const ObjectResources &own,
            double tolerance, bool hides_backs) {
    const Mesh &mesh = *own.mesh;
    const BoundObject bounded = bound_object(scene, technique, object, own);
    const LitVertices lit = lit_vertices(scene, technique, object, mesh);
    const double highlight = highlight_rounding(technique, bounded.exponent);
    const bool mirrored = is_mirrored(object.transform);
    const bool unproved = may_lose_half_vector(bounded);
    Proof proof;
    proof.choice.parts.insert(proof.choice.parts.begin(), {Frequency::per_vertex});
    for (const BoundLight &light : bounded.lights) {
        proof.lights |= LightSet{1} << light.index;
    }
    proof.choice.part_of.assign(mesh.triangles.size(), per_pixel);
    proof.seen.assign(mesh.triangles.size(), proof.lights);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (t % 128 == 0) {
            let_others_run();
        }
        const glm::uvec3 &corner = mesh.triangles[t];
        const auto of = [&](const std::vector<glm::dvec3> &values) {
            return Linear{values[corner.x], values[corner.y], values[corner.z]};
        };
        const BoundTriangle triangle{of(lit.positions), of(lit.normals)};
        if (hides_backs && shows_back(scene.camera, triangle.position, mirrored)) {
            proof.choice.part_of[t] = ObjectChoice::hidden;
            continue;
        }
        const double area = seen_area(scene.camera, triangle.position);
        ++proof.choice.facing;
        proof.choice.area += area;
        const Bound bound = shading_bound(bounded, triangle, tolerance);
        const double rounding = 2 * (body_rounding * (bound.body + bounded.constant) + highlight * bound.highlight);
        if (const double all = bound.interpolation + rounding; all <= tolerance && !unproved) {
            proof.choice.part_of[t] = per_vertex;
            ++proof.choice.lit_per_vertex;
            proof.choice.area_per_vertex += area;
            proof.bound = std::max(proof.bound, all);
        }
        proof.seen[t] = bound.lights & proof.lights;
        proof.area_of_seen[proof.choice.part_of[t]][proof.seen[t]] += area;
    }
    return proof;
}

/// What is proved saves too little: all is lit per pixel.
void give_up_vertices(Proof &proof) {
    for (std::uint8_t &part : proof.choice.part_of) {
        part = part == per_vertex ? per_pixel : part;
    }
    for (const auto &[seen, area] : proof.area_of_seen[per_vertex]) {
        proof.area_of_seen[per_pixel][seen] += area;
    }
    proof.choice.lit_per_vertex = 0;
    proof.choice.area_per_vertex = proof.bound = 0;
}

/// What is lit per vertex has few places where a light could be left out.
void leave_out_lights(Proof &proof) {
    const double least = least_saved * proof.choice.area * std::popcount(proof.lights);
    const LightGroups groups = group_by_lights(proof.area_of_seen[per_pixel], least, most_light_groups);
    proof.choice.parts[per_pixel].lights = groups.lights[0];
    for (std::size_t group = 1; group < groups.lights.size(); ++group) {
        proof.choice.parts.push_back({Frequency::per_pixel, groups.lights[group]});
    }
    for (std::size_t t = 0; t < proof.seen.size(); ++t) {
        if (std::uint8_t &part = proof.choice.part_of[t]; part == per_pixel) {
            part = static_cast<std::uint8_t>(per_pixel + groups.group_of.at(proof.seen[t]));
        }
    }
}

/// Nothing is split: one draw of all triangles.
ObjectChoice whole(ObjectChoice choice, const Mesh &mesh) {
    choice.parts.assign(1, {});
    choice.part_of.assign(mesh.triangles.size(), 0);
    return choice;
}

} // namespace

double Choice::share() const {
    double lit = 0, all = 0;
    for (const ObjectChoice &object : objects) {
        lit += object.area_per_vertex;
        all += object.area;
    }
    return all > 0 ? lit / all : 0;
}

Choice choose(const Scene &scene, const std::vector<ObjectResources> &resources, const Technique &given,
              double aspect) {
    const auto start = std::chrono::steady_clock::now();
    const Technique technique = as_it_shows(given, scene);
    Choice choice;
    choice.nothing_proved = why_nothing(technique);
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Object &object = scene.objects[i];
        const Mesh &mesh = *resources[i].mesh;
        const bool hides_backs = back_faces_hidden(scene.camera, aspect, object.transform, mesh) &&
                                 technique.position == LightingPosition::world;
        Proof proof;
        if (*choice.nothing_proved == '\0') {
            proof = prove(scene, technique, object, resources[i], technique.tolerance, hides_backs);
        }
        if (proof.choice.area_per_vertex <= least_share * proof.choice.area) {
            give_up_vertices(proof);
        }
        bool splits = false;
        if (!proof.seen.empty()) { // else nothing was tried
            leave_out_lights(proof);
            splits = proof.choice.lit_per_vertex > 0 || proof.choice.parts[per_pixel].lights != proof.lights;
        }
        choice.bound = std::max(choice.bound, proof.bound);
        choice.objects.push_back(splits ? std::move(proof.choice) : whole(std::move(proof.choice), mesh));
    }
    choice.milliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return choice;
}

} // namespace sandbox::certificate

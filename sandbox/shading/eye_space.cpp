#include "shading/eye_space.h"

#include "scene/light_kind.h"
#include "scene/space.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace sandbox {
namespace {

constexpr double smallest = 1e-16; ///< its square is 1e-32: far from float32's 1e-38
constexpr double largest = 1e16;

/// No vertex is farther from the eye than that.
double reach_of(const Camera &camera, const Object &object, const Mesh &mesh) {
    const Bounds &bounds = mesh.bounds;
    const glm::dvec3 middle = linear_part(object.transform) * (0.5 * (bounds.low + bounds.high));
    const glm::dvec3 half = 0.5 * (bounds.high - bounds.low) * glm::abs(object.transform.scale);
    return glm::length(middle + (object.transform.translate - camera.position)) + half.x + half.y + half.z;
}

/// A power of two that brings lengths between these, and as far as the lights from `origin`, to where their squares are
/// float32's.
double length_scale(const Scene &scene, const glm::dvec3 &origin, double low, double high) {
    for (const Light &light : scene.lights) {
        if (has_position(light)) {
            high = std::max(high, glm::length(light.position - origin));
        }
    }
    if (low >= smallest && high <= largest) {
        return 1;
    }
    return std::exp2(-std::nearbyint(0.5 * (std::log2(low) + std::log2(high))));
}

double length_scale(const Scene &scene, const Object &object, const Mesh &mesh) {
    const double reach = reach_of(scene.camera, object, mesh);
    const double near = scene.camera.near_plane;
    return length_scale(scene, scene.camera.position, reach > 0 ? std::min(reach, near) : near, std::max(reach, near));
}

double largest_element(const glm::dmat3 &m) {
    double largest = 0;
    for (int i = 0; i < 9; ++i) {
        largest = std::max(largest, std::abs(m[i / 3][i % 3]));
    }
    return largest;
}

glm::dmat3 normal_matrix(const glm::dmat3 &linear) {
    const double scale = largest_element(linear);
    if (scale == 0) {
        return glm::dmat3(1);
    }
    const glm::dmat3 m = linear / scale; // products of elements neither overflow nor vanish
    const glm::dmat3 cofactor(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    const double sign = glm::dot(m[0], cofactor[0]) < 0 ? -1 : 1;
    const double largest = largest_element(cofactor);
    return largest > 0 ? cofactor * (sign / largest) : m;
}

/// World space; holds every vertex.
struct Ball {
    glm::dvec3 center;
    double radius;
};
Ball bounding_ball(const Object &object, const Mesh &mesh) {
    const glm::dmat3 linear = linear_part(object.transform);
    const glm::dvec3 half = 0.5 * (mesh.bounds.high - mesh.bounds.low);
    return {linear * (0.5 * (mesh.bounds.low + mesh.bounds.high)) + object.transform.translate,
            half.x * glm::length(linear[0]) + half.y * glm::length(linear[1]) + half.z * glm::length(linear[2])};
}

} // namespace

glm::dmat3 normal_matrix(Normals normals, const Camera &camera, const Object &object, const EyeSpace &space) {
    switch (normals) {
    case Normals::inverse_transpose:
        break;
    case Normals::model_matrix:
    case Normals::unnormalized:
        return linear_part(object.transform);
    case Normals::untransformed:
        return glm::dmat3(1);
    case Normals::cofactor:
        return is_mirrored(object.transform) ? -space.normals : space.normals;
    case Normals::view_space:
        return world_to_view_axes(camera) * space.normals;
    }
    return space.normals;
}

glm::dvec3 buffer_origin(const Mesh &mesh) {
    const Bounds &bounds = mesh.bounds;
    const glm::dvec3 middle = 0.5 * (bounds.low + bounds.high);
    const double extent = glm::length(bounds.high - bounds.low);
    // Nearer than that, at most four of float32's bits are lost.
    const bool far = glm::length(middle) > 8 * extent;
    return far ? middle : glm::dvec3(0);
}

EyeSpace eye_space(const Scene &scene, const Object &object, const Mesh &mesh, const Technique &technique,
                   bool guarded) {
    EyeSpace space;
    const glm::dmat3 linear = linear_part(object.transform);
    space.origin = buffer_origin(mesh);
    space.scale = length_scale(scene, object, mesh);
    const glm::dvec3 moved = linear * space.origin;
    space.model = glm::dmat4(linear * space.scale);
    space.model[3] =
        glm::dvec4((moved + (object.transform.translate - scene.camera.position)) * space.scale, space.scale);
    space.normals = normal_matrix(linear);
    const bool absolute = technique.position == LightingPosition::absolute || technique.model == Model::own;
    space.afar = guarded && !absolute && technique.position == LightingPosition::world && is_afar(scene, object, mesh);
    space.lit_scale = absolute ? 1 : space.scale;
    space.lit_model = space.model;
    space.lit_origin = scene.camera.position;
    space.eye = (scene.camera.position - moved) * space.lit_scale;
    if (space.afar) {
        const auto [center, radius] = bounding_ball(object, mesh);
        space.lit_origin = center;
        // A light on the surface is as near as a rounding of positions.
        space.lit_scale =
            radius > 0 ? length_scale(scene, center, 0x1p-24 * radius, glm::length(center - scene.camera.position))
                       : space.scale;
    }
    if (absolute || space.afar) {
        space.lit_origin = absolute ? glm::dvec3(0) : space.lit_origin;
        const glm::dvec3 from_there = moved + (object.transform.translate - space.lit_origin);
        space.lit_model = glm::dmat4(linear * space.lit_scale);
        space.lit_model[3] = glm::dvec4(from_there * space.lit_scale, space.lit_scale);
        space.eye = (scene.camera.position - space.lit_origin) * space.lit_scale;
    }
    space.depth_per_octave = 1 / std::log2(scene.camera.far_plane / scene.camera.near_plane);
    space.depth_at_1 = -std::log2(scene.camera.near_plane * space.scale) * space.depth_per_octave;
    return space;
}

glm::dmat4 model_view_projection(const Scene &scene, const EyeSpace &space, double aspect) {
    return view_projection(scene.camera, aspect) * space.model;
}

glm::dmat4 without_depth(glm::dmat4 model_view_projection) {
    for (int column = 0; column < 4; ++column) {
        model_view_projection[column].z = 0;
    }
    return model_view_projection;
}

bool is_afar(const Scene &scene, const Object &object, const Mesh &mesh) {
    const auto [center, radius] = bounding_ball(object, mesh);
    return glm::length(center - scene.camera.position) > 32 * radius;
}

bool is_wide(const Scene &scene, const Object &object, const Mesh &mesh) {
    const auto [center, radius] = bounding_ball(object, mesh);
    const double distance = glm::length(center - scene.camera.position) - radius;
    return is_perspective(scene.camera) && radius > 1e4 * std::max(distance, scene.camera.near_plane);
}

bool is_deep(const Scene &scene, const std::vector<ObjectResources> &resources) {
    const Camera &camera = scene.camera;
    bool deep = is_deep(camera);
    for (std::size_t i = 0; i < scene.objects.size() && !deep && is_perspective(camera); ++i) {
        deep = reach_of(camera, scene.objects[i], *resources[i].mesh) >= deep_range * camera.near_plane;
    }
    return deep;
}

bool is_deep(const Camera &camera) {
    return is_perspective(camera) && camera.far_plane >= deep_range * camera.near_plane;
}

} // namespace sandbox

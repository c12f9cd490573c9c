#include "render/seen_part.h"

#include "scene/space.h"

#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace sandbox {
namespace {

constexpr double narrow = 64; ///< an object's radius over the view's, from which on its mesh is cut
constexpr double margin = 4;  ///< what is kept, over what is seen: no cut lies in the picture

struct Corner {
    glm::dvec3 position, normal;
    glm::dvec2 uv{0};
    glm::dvec3 color{1};
    glm::dvec3 seen; ///< right, up and forward from the eye
};

Corner between(const Corner &a, const Corner &b, double share) {
    return {glm::mix(a.position, b.position, share), glm::mix(a.normal, b.normal, share), glm::mix(a.uv, b.uv, share),
            glm::mix(a.color, b.color, share), glm::mix(a.seen, b.seen, share)};
}

using Polygon = std::vector<Corner>;

/// What lies on the side of `seen` where dot(normal, seen) + distance >= 0.
struct Plane {
    glm::dvec3 normal;
    double distance = 0;
    [[nodiscard]] double at(const glm::dvec3 &seen) const { return glm::dot(normal, seen) + distance; }
};

/// The part of a convex polygon on that side.
Polygon cut(const Polygon &polygon, const Plane &plane) {
    Polygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Corner &here = polygon[i];
        const Corner &next = polygon[(i + 1) % polygon.size()];
        const double a = plane.at(here.seen);
        const double b = plane.at(next.seen);
        if (a >= 0) {
            kept.push_back(here);
        }
        if ((a >= 0) != (b >= 0)) {
            kept.push_back(between(here, next, a / (a - b)));
        }
    }
    return kept;
}

struct NarrowView {
    glm::dmat3 axes; ///< from world axes to right, up, forward
    glm::dvec3 eye;
    bool orthographic;
    double half_width, half_height; ///< at a distance of 1 or, if orthographic, at every distance

    NarrowView(const Camera &camera, double aspect) : eye(camera.position), orthographic(is_orthographic(camera)) {
        const CameraAxes own = camera_axes(camera);
        axes = glm::transpose(glm::dmat3(own.right, own.up, own.forward));
        half_height = orthographic ? camera.height / 2 : std::tan(glm::radians(camera.fov_y_degrees) / 2);
        half_width = half_height * aspect;
    }

    /// Half the picture's diagonal, at `distance`.
    [[nodiscard]] double radius(double distance) const {
        return std::hypot(half_width, half_height) * (orthographic ? 1 : distance);
    }

    [[nodiscard]] std::array<Plane, 4> planes() const {
        const auto plane = [&](const glm::dvec3 &inward, double half) {
            const double kept = margin * half; // through the eye, or beside it
            return orthographic ? Plane{inward, kept} : Plane{inward + glm::dvec3(0, 0, kept)};
        };
        return {plane({1, 0, 0}, half_width), plane({-1, 0, 0}, half_width), plane({0, 1, 0}, half_height),
                plane({0, -1, 0}, half_height)};
    }
};

/// Does the view see so little of the object, and does what is interpolated over it stay the same if it is cut?
bool should_cut(const NarrowView &view, const Object &object, const Mesh &mesh) {
    const glm::dmat3 linear = linear_part(object.transform);
    const glm::dvec3 half = 0.5 * (mesh.bounds.high - mesh.bounds.low);
    const double radius = glm::length(half * glm::abs(object.transform.scale));
    const glm::dvec3 middle = linear * (0.5 * (mesh.bounds.low + mesh.bounds.high)) + object.transform.translate;
    const double farthest = glm::length(middle - view.eye) + radius;
    // A checker is laid over the whole mesh. An uneven scale gives the vertices' normals unlike weights.
    return radius > narrow * view.radius(farthest) && !object.material.checker && scales_evenly(linear);
}

Mesh seen_part(const NarrowView &view, const Object &object, const Mesh &mesh) {
    const glm::dmat3 linear = linear_part(object.transform);
    const glm::dvec3 offset = object.transform.translate - view.eye;
    const auto corner = [&](std::size_t i) {
        return Corner{mesh.positions[i], mesh.normals[i], mesh.uvs.empty() ? glm::dvec2(0) : mesh.uvs[i],
                      mesh.colors.empty() ? glm::dvec3(1) : mesh.colors[i],
                      view.axes * (linear * mesh.positions[i] + offset)};
    };
    // Elsewhere the vertex stage makes normals unit, which a normal between two vertices is not.
    const bool any_normals = glm::abs(object.transform.scale) == glm::dvec3(1) || linear == glm::dmat3(linear[0][0]);
    Mesh part;
    for (const glm::uvec3 &triangle : mesh.triangles) {
        Polygon polygon{corner(triangle.x), corner(triangle.y), corner(triangle.z)};
        const bool one_normal = polygon[0].normal == polygon[1].normal && polygon[1].normal == polygon[2].normal;
        for (const Plane &plane : view.planes()) {
            const Polygon left = cut(polygon, plane);
            polygon = any_normals || one_normal || left.empty() ? left : polygon;
        }
        const auto first = static_cast<unsigned>(part.positions.size());
        for (const Corner &kept : polygon) {
            part.positions.push_back(kept.position);
            part.normals.push_back(kept.normal);
            if (!mesh.uvs.empty()) {
                part.uvs.push_back(kept.uv);
            }
            if (!mesh.colors.empty()) {
                part.colors.push_back(kept.color);
            }
        }
        for (unsigned i = 2; i < polygon.size(); ++i) {
            part.triangles.emplace_back(first, first + i - 1, first + i);
        }
    }
    return part;
}

} // namespace

std::vector<ObjectResources> seen_parts(const Scene &scene, const Technique &technique,
                                        std::vector<ObjectResources> resources, double aspect) {
    const bool only_unit_normals =
        technique.frequency == Frequency::per_pixel && technique.position == LightingPosition::world &&
        technique.attenuation == AttenuationAt::exact && technique.renormalize == Renormalize::on &&
        technique.normals != Normals::unnormalized && technique.model != Model::own;
    const NarrowView view(scene.camera, aspect);
    for (std::size_t i = 0; only_unit_normals && i < resources.size(); ++i) {
        const Mesh &mesh = *resources[i].mesh;
        const Object &object = scene.objects[i];
        if (!should_cut(view, object, mesh)) {
            continue;
        }
        Mesh part = seen_part(view, object, mesh);
        if (part.triangles.empty()) {
            continue;
        }
        summarise(part);
        part.closed = back_faces_hidden(scene.camera, aspect, object.transform, mesh);
        part.opposing_normals = mesh.opposing_normals;
        resources[i].mesh = std::make_shared<const Mesh>(std::move(part));
    }
    return resources;
}

} // namespace sandbox

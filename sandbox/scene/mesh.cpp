#include "scene/mesh.h"

#include "scene/shapes.h"

#include <algorithm>
#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace sandbox {
namespace {

/// Three normals interpolate to 0 only if no open half space holds them, which needs a pair at 120 degrees or more.
bool has_opposing_normals(const Mesh &mesh) {
    const auto &n = mesh.normals;
    return std::ranges::any_of(mesh.triangles, [&](const glm::uvec3 &t) {
        return glm::dot(n[t.x], n[t.y]) < -0.49 || glm::dot(n[t.y], n[t.z]) < -0.49 || glm::dot(n[t.z], n[t.x]) < -0.49;
    });
}

/// The winding's normal against the sum of the vertices' normals.
bool runs_against_normals(const Mesh &mesh, const glm::uvec3 &t) {
    const auto &p = mesh.positions;
    const auto &n = mesh.normals;
    return glm::dot(glm::cross(p[t.y] - p[t.x], p[t.z] - p[t.x]), n[t.x] + n[t.y] + n[t.z]) < 0;
}

} // namespace

void summarise(Mesh &mesh) {
    mesh.bounds = bounds_of(mesh);
    mesh.opposing_normals = has_opposing_normals(mesh);
    mesh.against_normals = static_cast<std::size_t>(std::ranges::count_if(
        mesh.triangles, [&](const glm::uvec3 &triangle) { return runs_against_normals(mesh, triangle); }));
}

std::string winding_note(std::size_t against_normals, std::size_t triangles) {
    return against_normals == 0 ? ""
                                : fmt::format("{} of {} triangles run clockwise as seen from the side of their "
                                              "normals: two_sided lights them from the wrong side",
                                              against_normals, triangles);
}

Mesh build_mesh(const Shape &shape) {
    Mesh mesh = shape_mesh(shape);
    summarise(mesh);
    return mesh;
}

double half_extent(const Mesh &mesh) {
    const Bounds bounds = bounds_of(mesh);
    const glm::dvec3 extent = glm::max(glm::abs(bounds.low), glm::abs(bounds.high));
    return std::max({extent.x, extent.y, extent.z});
}

Bounds bounds_of(const Mesh &mesh) {
    if (mesh.positions.empty()) {
        return {};
    }
    Bounds bounds{mesh.positions[0], mesh.positions[0]};
    for (const glm::dvec3 &p : mesh.positions) {
        bounds.low = glm::min(bounds.low, p);
        bounds.high = glm::max(bounds.high, p);
    }
    return bounds;
}

glm::dvec3 facet_normal(const Mesh &mesh, const glm::uvec3 &t) {
    const auto &p = mesh.positions;
    const glm::dvec3 mean = mesh.normals[t.x] + mesh.normals[t.y] + mesh.normals[t.z];
    const glm::dvec3 normal = glm::cross(p[t.y] - p[t.x], p[t.z] - p[t.x]);
    const double length = glm::length(normal);
    if (length == 0) {
        return mean;
    }
    return glm::dot(normal, mean) < 0 ? -normal / length : normal / length;
}

} // namespace sandbox

#include "scene/mesh.h"

#include "scene/shapes.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace sandbox {
namespace {

struct Builder {
    Mesh operator()(const SphereShape &shape) const { return sphere_mesh(shape); }
    Mesh operator()(const BoxShape &shape) const { return box_mesh(shape); }
    Mesh operator()(const PlaneShape &shape) const { return plane_mesh(shape); }
    Mesh operator()(const CylinderShape &shape) const { return cylinder_mesh(shape); }
    Mesh operator()(const TorusShape &shape) const { return torus_mesh(shape); }
    Mesh operator()(const ObjShape &) const {
        assert(false && "an OBJ is read by Resources");
        return {};
    }
};

/// Three normals interpolate to 0 only if no open half space holds them, which needs a pair at 120 degrees or more.
bool has_opposing_normals(const Mesh &mesh) {
    const auto &n = mesh.normals;
    return std::ranges::any_of(mesh.triangles, [&](const glm::uvec3 &t) {
        return glm::dot(n[t.x], n[t.y]) < -0.49 || glm::dot(n[t.y], n[t.z]) < -0.49 || glm::dot(n[t.z], n[t.x]) < -0.49;
    });
}

} // namespace

void summarise(Mesh &mesh) {
    mesh.bounds = bounds_of(mesh);
    mesh.opposing_normals = has_opposing_normals(mesh);
}

Mesh build_mesh(const Shape &shape) {
    Mesh mesh = std::visit(Builder{}, shape);
    summarise(mesh);
    return mesh;
}

double half_extent(const Mesh &mesh) {
    double extent = 0;
    for (const glm::dvec3 &p : mesh.positions) {
        extent = std::max({extent, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    }
    return extent;
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

} // namespace sandbox

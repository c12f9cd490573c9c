#include "scene/mesh.h"

#include "scene/shapes.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>

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

} // namespace

Mesh build_mesh(const Shape &shape) { return std::visit(Builder{}, shape); }

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

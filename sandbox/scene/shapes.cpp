#include "scene/shapes.h"

#include <cassert>
#include <cmath>
#include <numbers>

namespace sandbox {
namespace {

/// Sines and cosines of n + 1 angles from 0 to `total`. A full circle ends exactly where it began and a half circle
/// exactly on the axis, so that seams and poles are watertight.
struct Arc {
    std::vector<double> sine, cosine;
    Arc(int n, double total) {
        for (int k = 0; k <= n; ++k) {
            sine.push_back(k == n ? 0 : std::sin(total * k / n));
            cosine.push_back(k == n ? std::round(std::cos(total)) : std::cos(total * k / n));
        }
    }
};

const double half_circle = std::numbers::pi;
const double full_circle = 2 * std::numbers::pi;

/// n + 1 coordinates from -size/2 to size/2, symmetric to the last bit.
std::vector<double> steps(double size, int n) {
    std::vector<double> out;
    for (int k = 0; k <= n; ++k) {
        out.push_back(size * ((2 * k - n) / (2.0 * n)));
    }
    return out;
}

struct Vertex {
    glm::dvec3 position, normal;
    glm::dvec2 uv;
};

void add_vertex(Mesh &mesh, const Vertex &vertex) {
    mesh.positions.push_back(vertex.position);
    mesh.normals.push_back(vertex.normal);
    mesh.uvs.push_back(vertex.uv);
}

/// (rows + 1) x (columns + 1) vertices: vertex_at(i, j, i / rows, j / columns) of row i and column j.
template <typename VertexAt> void add_vertices(Mesh &mesh, int rows, int columns, const VertexAt &vertex_at) {
    for (std::size_t i = 0; i <= static_cast<std::size_t>(rows); ++i) {
        for (std::size_t j = 0; j <= static_cast<std::size_t>(columns); ++j) {
            add_vertex(mesh, vertex_at(i, j, static_cast<double>(i) / rows, static_cast<double>(j) / columns));
        }
    }
}

unsigned vertex_count(const Mesh &mesh) { return static_cast<unsigned>(mesh.positions.size()); }

/// The quads of a grid whose (rows + 1) x (columns + 1) vertices begin at `start`. Each is split from vertex (i, j) to
/// (i + 1, j + 1) and is counter-clockwise along the row first or, if `clockwise`, along the column first. Where
/// `poles`, the first and the last row are points, and the triangles without an area are left out.
void add_quads(Mesh &mesh, unsigned start, int rows, int columns, bool clockwise = false, bool poles = false) {
    const auto stride = static_cast<unsigned>(columns) + 1;
    for (unsigned i = 0; i < static_cast<unsigned>(rows); ++i) {
        for (unsigned j = 0; j < static_cast<unsigned>(columns); ++j) {
            const unsigned a = start + i * stride + j;
            const unsigned c = a + stride + 1;
            const unsigned b = clockwise ? a + stride : a + 1;
            const unsigned d = clockwise ? a + 1 : a + stride;
            if (!poles || i > 0) {
                mesh.triangles.emplace_back(a, b, c);
            }
            if (!poles || i + 1 < static_cast<unsigned>(rows)) {
                mesh.triangles.emplace_back(a, c, d);
            }
        }
    }
}

/// One n x n face of a box: `right` and `up` are axes (0, 1, 2) with signs, seen from outside.
struct Face {
    int normal, normal_sign, right, right_sign, up, up_sign;
};

void add_face(Mesh &mesh, const BoxShape &shape, const Face &face) {
    const int n = shape.divisions;
    const std::vector<double> across = steps(shape.size[face.right] * face.right_sign, n);
    const std::vector<double> down = steps(-shape.size[face.up] * face.up_sign, n);
    glm::dvec3 normal(0);
    normal[face.normal] = face.normal_sign;
    const unsigned start = vertex_count(mesh);
    add_vertices(mesh, n, n, [&](std::size_t i, std::size_t j, double y, double x) {
        glm::dvec3 p = normal * (shape.size / 2.0);
        p[face.right] = across[j];
        p[face.up] = down[i];
        return Vertex{p, normal, {x, 1 - y}};
    });
    add_quads(mesh, start, n, n, true);
}

/// A disc facing up (sign 1) or down (-1) at height y, as a fan about its centre.
void add_cap(Mesh &mesh, const CylinderShape &shape, const Arc &circle, double y, int sign) {
    const glm::dvec3 normal(0, sign, 0);
    const unsigned centre = vertex_count(mesh);
    add_vertex(mesh, {{0, y, 0}, normal, {0.5, 0.5}});
    const auto segments = static_cast<unsigned>(shape.segments);
    for (unsigned j = 0; j < segments; ++j) {
        const double c = circle.cosine[j];
        const double s = circle.sine[j];
        add_vertex(mesh, {{shape.radius * c, y, shape.radius * s}, normal, {0.5 + 0.5 * c, 0.5 - 0.5 * sign * s}});
    }
    for (unsigned j = 0; j < segments; ++j) {
        const unsigned a = centre + 1 + j;
        const unsigned b = centre + 1 + (j + 1) % segments;
        mesh.triangles.emplace_back(centre, sign > 0 ? b : a, sign > 0 ? a : b);
    }
}

Mesh mesh_of(const SphereShape &shape) {
    Mesh mesh;
    mesh.closed = true;
    const Arc down(shape.rings, half_circle);
    const Arc round(shape.segments, full_circle);
    add_vertices(mesh, shape.rings, shape.segments, [&](std::size_t i, std::size_t j, double y, double x) {
        const glm::dvec3 n(down.sine[i] * round.cosine[j], down.cosine[i], down.sine[i] * round.sine[j]);
        return Vertex{shape.radius * n, n, {x, 1 - y}};
    });
    add_quads(mesh, 0, shape.rings, shape.segments, false, true);
    return mesh;
}

Mesh mesh_of(const BoxShape &shape) {
    Mesh mesh;
    mesh.closed = true;
    constexpr Face faces[] = {{0, 1, 2, -1, 1, 1}, {0, -1, 2, 1, 1, 1}, {1, 1, 0, 1, 2, -1},
                              {1, -1, 0, 1, 2, 1}, {2, 1, 0, 1, 1, 1},  {2, -1, 0, -1, 1, 1}};
    for (const Face &face : faces) {
        add_face(mesh, shape, face);
    }
    return mesh;
}

Mesh mesh_of(const PlaneShape &shape) {
    Mesh mesh;
    const BoxShape flat{{shape.size.x, 0, shape.size.y}, shape.divisions};
    add_face(mesh, flat, {1, 1, 0, 1, 2, -1});
    return mesh;
}

Mesh mesh_of(const CylinderShape &shape) {
    Mesh mesh;
    mesh.closed = shape.caps;
    const Arc round(shape.segments, full_circle);
    const std::vector<double> heights = steps(-shape.height, shape.rings);
    add_vertices(mesh, shape.rings, shape.segments, [&](std::size_t i, std::size_t j, double y, double x) {
        const glm::dvec3 n(round.cosine[j], 0, round.sine[j]);
        return Vertex{shape.radius * n + glm::dvec3(0, heights[i], 0), n, {x, 1 - y}};
    });
    add_quads(mesh, 0, shape.rings, shape.segments);
    if (shape.caps) {
        add_cap(mesh, shape, round, heights.front(), 1);
        add_cap(mesh, shape, round, heights.back(), -1);
    }
    return mesh;
}

Mesh mesh_of(const TorusShape &shape) {
    Mesh mesh;
    mesh.closed = true;
    const Arc around(shape.rings, full_circle);
    const Arc tube(shape.segments, full_circle);
    add_vertices(mesh, shape.rings, shape.segments, [&](std::size_t i, std::size_t j, double y, double x) {
        const glm::dvec3 out(around.cosine[i], 0, around.sine[i]);
        const glm::dvec3 n = tube.cosine[j] * out + glm::dvec3(0, tube.sine[j], 0);
        return Vertex{shape.radius * out + shape.tube_radius * n, n, {y, x}};
    });
    add_quads(mesh, 0, shape.rings, shape.segments);
    return mesh;
}

Mesh mesh_of(const ObjShape &) {
    assert(false && "an OBJ is read by Resources");
    return {};
}

} // namespace

Mesh shape_mesh(const Shape &shape) {
    return std::visit([](const auto &built_in) { return mesh_of(built_in); }, shape);
}

} // namespace sandbox

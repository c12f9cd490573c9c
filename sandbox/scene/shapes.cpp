#include "scene/shapes.h"

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

void add_vertex(Mesh &mesh, glm::dvec3 position, glm::dvec3 normal, glm::dvec2 uv) {
    mesh.positions.push_back(position);
    mesh.normals.push_back(normal);
    mesh.uvs.push_back(uv);
}

unsigned vertex_count(const Mesh &mesh) { return static_cast<unsigned>(mesh.positions.size()); }

/// The two triangles of a grid cell with corners a = (i, j), b = (i, j + 1), c = (i + 1, j + 1), d = (i + 1, j): split
/// from a to c, counter-clockwise in the order a, b, c, d.
void add_quad(Mesh &mesh, unsigned a, unsigned b, unsigned c, unsigned d, bool first = true, bool second = true) {
    if (first) {
        mesh.triangles.emplace_back(a, b, c);
    }
    if (second) {
        mesh.triangles.emplace_back(a, c, d);
    }
}

/// Quads of a grid whose (rows + 1) x (columns + 1) vertices begin at `start`, counter-clockwise along the row first.
void add_grid(Mesh &mesh, unsigned start, int rows, int columns) {
    const auto stride = static_cast<unsigned>(columns) + 1;
    for (unsigned i = 0; i < static_cast<unsigned>(rows); ++i) {
        for (unsigned j = 0; j < static_cast<unsigned>(columns); ++j) {
            const unsigned a = start + i * stride + j;
            add_quad(mesh, a, a + 1, a + stride + 1, a + stride);
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
    for (int i = 0; i <= n; ++i) {
        for (int j = 0; j <= n; ++j) {
            glm::dvec3 p = normal * (shape.size / 2.0);
            p[face.right] = across[static_cast<std::size_t>(j)];
            p[face.up] = down[static_cast<std::size_t>(i)];
            add_vertex(mesh, p, normal, {j / static_cast<double>(n), 1 - i / static_cast<double>(n)});
        }
    }
    const auto stride = static_cast<unsigned>(n) + 1;
    for (unsigned i = 0; i < static_cast<unsigned>(n); ++i) {
        for (unsigned j = 0; j < static_cast<unsigned>(n); ++j) {
            const unsigned a = start + i * stride + j;
            add_quad(mesh, a, a + stride, a + stride + 1, a + 1);
        }
    }
}

/// A disc facing up (sign 1) or down (-1) at height y, as a fan about its centre.
void add_cap(Mesh &mesh, const CylinderShape &shape, const Arc &circle, double y, int sign) {
    const glm::dvec3 normal(0, sign, 0);
    const unsigned centre = vertex_count(mesh);
    add_vertex(mesh, {0, y, 0}, normal, {0.5, 0.5});
    const auto segments = static_cast<unsigned>(shape.segments);
    for (unsigned j = 0; j < segments; ++j) {
        const double c = circle.cosine[j];
        const double s = circle.sine[j];
        add_vertex(mesh, {shape.radius * c, y, shape.radius * s}, normal, {0.5 + 0.5 * c, 0.5 - 0.5 * sign * s});
    }
    for (unsigned j = 0; j < segments; ++j) {
        const unsigned a = centre + 1 + j;
        const unsigned b = centre + 1 + (j + 1) % segments;
        mesh.triangles.emplace_back(centre, sign > 0 ? b : a, sign > 0 ? a : b);
    }
}

} // namespace

Mesh sphere_mesh(const SphereShape &shape) {
    Mesh mesh;
    mesh.closed = true;
    const Arc down(shape.rings, half_circle);
    const Arc round(shape.segments, full_circle);
    const auto rings = static_cast<unsigned>(shape.rings);
    const auto segments = static_cast<unsigned>(shape.segments);
    for (unsigned i = 0; i <= rings; ++i) {
        for (unsigned j = 0; j <= segments; ++j) {
            const glm::dvec3 n(down.sine[i] * round.cosine[j], down.cosine[i], down.sine[i] * round.sine[j]);
            add_vertex(mesh, shape.radius * n, n,
                       {j / static_cast<double>(segments), 1 - i / static_cast<double>(rings)});
        }
    }
    for (unsigned i = 0; i < rings; ++i) {
        for (unsigned j = 0; j < segments; ++j) {
            const unsigned a = i * (segments + 1) + j;
            const unsigned below = a + segments + 1;
            add_quad(mesh, a, a + 1, below + 1, below, i > 0, i + 1 < rings);
        }
    }
    return mesh;
}

Mesh box_mesh(const BoxShape &shape) {
    Mesh mesh;
    mesh.closed = true;
    constexpr Face faces[] = {{0, 1, 2, -1, 1, 1}, {0, -1, 2, 1, 1, 1}, {1, 1, 0, 1, 2, -1},
                              {1, -1, 0, 1, 2, 1}, {2, 1, 0, 1, 1, 1},  {2, -1, 0, -1, 1, 1}};
    for (const Face &face : faces) {
        add_face(mesh, shape, face);
    }
    return mesh;
}

Mesh plane_mesh(const PlaneShape &shape) {
    Mesh mesh;
    const BoxShape flat{{shape.size.x, 0, shape.size.y}, shape.divisions};
    add_face(mesh, flat, {1, 1, 0, 1, 2, -1});
    return mesh;
}

Mesh cylinder_mesh(const CylinderShape &shape) {
    Mesh mesh;
    mesh.closed = shape.caps;
    const Arc round(shape.segments, full_circle);
    const std::vector<double> heights = steps(-shape.height, shape.rings);
    const auto rings = static_cast<unsigned>(shape.rings);
    const auto segments = static_cast<unsigned>(shape.segments);
    for (unsigned i = 0; i <= rings; ++i) {
        for (unsigned j = 0; j <= segments; ++j) {
            const glm::dvec3 n(round.cosine[j], 0, round.sine[j]);
            add_vertex(mesh, shape.radius * n + glm::dvec3(0, heights[i], 0), n,
                       {j / static_cast<double>(segments), 1 - i / static_cast<double>(rings)});
        }
    }
    add_grid(mesh, 0, shape.rings, shape.segments);
    if (shape.caps) {
        add_cap(mesh, shape, round, heights.front(), 1);
        add_cap(mesh, shape, round, heights.back(), -1);
    }
    return mesh;
}

Mesh torus_mesh(const TorusShape &shape) {
    Mesh mesh;
    mesh.closed = true;
    const Arc around(shape.rings, full_circle);
    const Arc tube(shape.segments, full_circle);
    const auto rings = static_cast<unsigned>(shape.rings);
    const auto segments = static_cast<unsigned>(shape.segments);
    for (unsigned i = 0; i <= rings; ++i) {
        const glm::dvec3 out(around.cosine[i], 0, around.sine[i]);
        for (unsigned j = 0; j <= segments; ++j) {
            const glm::dvec3 n = tube.cosine[j] * out + glm::dvec3(0, tube.sine[j], 0);
            add_vertex(mesh, shape.radius * out + shape.tube_radius * n, n,
                       {i / static_cast<double>(rings), j / static_cast<double>(segments)});
        }
    }
    add_grid(mesh, 0, shape.rings, shape.segments);
    return mesh;
}

} // namespace sandbox

#include "scene/mesh.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <map>
#include <numbers>
#include <set>
#include <tuple>

namespace sandbox {
namespace {

using Point = std::tuple<double, double, double>;
Point point(const glm::dvec3 &p) { return {p.x + 0.0, p.y + 0.0, p.z + 0.0}; } // + 0.0: -0 is 0

glm::dvec3 area_vector(const Mesh &mesh, const glm::uvec3 &t) {
    return glm::cross(mesh.positions[t.y] - mesh.positions[t.x], mesh.positions[t.z] - mesh.positions[t.x]) / 2.0;
}

double volume(const Mesh &mesh) {
    double sum = 0;
    for (const glm::uvec3 &t : mesh.triangles) {
        sum += glm::dot(mesh.positions[t.x], area_vector(mesh, t)) / 3;
    }
    return sum;
}

/// V - E + F of the surface whose vertices at the same place are one; fails unless each edge has one triangle on
/// each side.
long euler_number(const Mesh &mesh) {
    std::set<Point> points;
    std::map<std::pair<Point, Point>, int> edges;
    for (const glm::uvec3 &t : mesh.triangles) {
        for (int k = 0; k < 3; ++k) {
            const Point a = point(mesh.positions[t[k]]);
            const Point b = point(mesh.positions[t[(k + 1) % 3]]);
            points.insert(a);
            ++edges[{a, b}];
        }
    }
    for (const auto &[edge, count] : edges) {
        EXPECT_EQ(count, 1);
        EXPECT_TRUE(edges.contains({edge.second, edge.first}));
    }
    return static_cast<long>(points.size()) - static_cast<long>(edges.size() / 2) +
           static_cast<long>(mesh.triangles.size());
}

void expect_sound(const Mesh &mesh) {
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
    ASSERT_EQ(mesh.uvs.size(), mesh.positions.size());
    for (const glm::dvec3 &normal : mesh.normals) {
        EXPECT_NEAR(glm::length(normal), 1, 1e-15); // a few roundings
    }
    for (const glm::dvec2 &uv : mesh.uvs) {
        EXPECT_TRUE(uv.x >= 0 && uv.x <= 1 && uv.y >= 0 && uv.y <= 1);
    }
    for (const glm::uvec3 &t : mesh.triangles) {
        const glm::dvec3 area = area_vector(mesh, t);
        EXPECT_GT(glm::length(area), 0);
        for (int k = 0; k < 3; ++k) {
            EXPECT_GT(glm::dot(area, mesh.normals[t[k]]), 0) << "the front is on the normals' side";
        }
    }
}

TEST(Sphere, FollowsItsFormula) {
    const Mesh mesh = build_mesh(SphereShape{2, 4, 6});
    expect_sound(mesh);
    EXPECT_EQ(mesh.positions.size(), 5U * 7U);
    EXPECT_EQ(mesh.triangles.size(), 2U * 6U * 3U); // 2 segments (rings - 1): no degenerate ones at the poles
    EXPECT_EQ(euler_number(mesh), 2);
    EXPECT_TRUE(mesh.closed);
    // i = 1, j = 1: t = 45 degrees, p = 60 degrees.
    const double root = std::sqrt(0.5);
    const glm::dvec3 expected(2 * root * 0.5, 2 * root, 2 * root * std::sqrt(0.75));
    EXPECT_NEAR(glm::distance(mesh.positions[7 + 1], expected), 0, 1e-15);
    EXPECT_EQ(mesh.uvs[7 + 1], glm::dvec2(1 / 6.0, 0.75));
    EXPECT_EQ(mesh.positions[7], mesh.positions[7 + 6]); // the seam
    EXPECT_EQ(mesh.positions[4 * 7 + 3], glm::dvec3(0, -2, 0));
    // Split from (i, j) to (i + 1, j + 1).
    EXPECT_EQ(mesh.triangles[6], glm::uvec3(7, 8, 15));
    EXPECT_EQ(mesh.triangles[7], glm::uvec3(7, 15, 14));
}

TEST(Sphere, TendsToTheTrueVolume) {
    // The error of an inscribed surface falls with the square of the step: about 2 (pi / 256)^2.
    EXPECT_NEAR(volume(build_mesh(SphereShape{1, 256, 512})) / (4 * std::numbers::pi / 3), 1, 2e-4);
}

TEST(Sphere, CanBeAsCoarseAsTheFormatAllows) {
    const Mesh mesh = build_mesh(SphereShape{1, 2, 3});
    expect_sound(mesh);
    EXPECT_EQ(mesh.triangles.size(), 6U);
    EXPECT_EQ(euler_number(mesh), 2);
}

TEST(Box, IsClosedAndExact) {
    const Mesh mesh = build_mesh(BoxShape{{0.1, 0.7, 3}, 3}); // sizes that binary fractions cannot hold
    expect_sound(mesh);
    EXPECT_EQ(mesh.positions.size(), 6U * 16U);
    EXPECT_EQ(mesh.triangles.size(), 6U * 18U);
    EXPECT_EQ(euler_number(mesh), 2);
    EXPECT_NEAR(volume(mesh), 0.1 * 0.7 * 3, 1e-15);
    EXPECT_TRUE(mesh.closed);
    const Bounds bounds = bounds_of(mesh);
    EXPECT_EQ(bounds.low, glm::dvec3(-0.05, -0.35, -1.5));
    EXPECT_EQ(bounds.high, glm::dvec3(0.05, 0.35, 1.5));
    EXPECT_EQ(half_extent(mesh), 1.5);
}

TEST(Plane, FacesUp) {
    const Mesh mesh = build_mesh(PlaneShape{{4, 2}, 2});
    expect_sound(mesh);
    EXPECT_EQ(mesh.positions.size(), 9U);
    EXPECT_EQ(mesh.triangles.size(), 8U);
    EXPECT_FALSE(mesh.closed);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        EXPECT_EQ(mesh.positions[i].y, 0);
        EXPECT_EQ(mesh.normals[i], glm::dvec3(0, 1, 0));
    }
    EXPECT_EQ(bounds_of(mesh).low, glm::dvec3(-2, 0, -1));
    EXPECT_EQ(bounds_of(mesh).high, glm::dvec3(2, 0, 1));
}

TEST(Cylinder, IsClosedWithCapsAndOpenWithout) {
    const Mesh closed = build_mesh(CylinderShape{0.5, 2, 8, 3, true});
    expect_sound(closed);
    EXPECT_EQ(closed.positions.size(), 4U * 9U + 2U * 9U);
    EXPECT_EQ(closed.triangles.size(), 2U * 8U * 3U + 2U * 8U);
    EXPECT_EQ(euler_number(closed), 2);
    EXPECT_TRUE(closed.closed);
    // An 8-gon's area: 4 r^2 sin(45 degrees) ... times the height.
    EXPECT_NEAR(volume(closed), 4 * 0.25 * std::sqrt(0.5) * 2, 1e-14); // 64 roundings
    const Mesh open = build_mesh(CylinderShape{0.5, 2, 8, 3, false});
    expect_sound(open);
    EXPECT_EQ(open.triangles.size(), 2U * 8U * 3U);
    EXPECT_FALSE(open.closed);
}

TEST(Torus, IsClosedWithAHole) {
    const Mesh mesh = build_mesh(TorusShape{1, 0.4, 12, 8});
    expect_sound(mesh);
    EXPECT_EQ(mesh.positions.size(), 13U * 9U);
    EXPECT_EQ(mesh.triangles.size(), 2U * 12U * 8U);
    EXPECT_EQ(euler_number(mesh), 0);
    EXPECT_TRUE(mesh.closed);
    EXPECT_EQ(mesh.positions[0], glm::dvec3(1.4, 0, 0));
    // 2 pi^2 R r^2; inscribed polygons of 512 corners lose about (2 pi / 512)^2.
    const double smooth = 2 * std::numbers::pi * std::numbers::pi * 0.16;
    EXPECT_NEAR(volume(build_mesh(TorusShape{1, 0.4, 512, 512})) / smooth, 1, 2e-4);
}

TEST(Bounds, OfNothingAreTheOrigin) {
    EXPECT_EQ(half_extent(Mesh{}), 0);
    EXPECT_EQ(bounds_of(Mesh{}).high, glm::dvec3(0));
}

} // namespace
} // namespace sandbox

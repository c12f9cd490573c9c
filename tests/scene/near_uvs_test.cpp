#include "scene/near_uvs.h"

#include "scene/obj_reader.h"
#include "scene/scene.h"

#include <cmath>
#include <fmt/format.h>
#include <glm/common.hpp>
#include <gtest/gtest.h>

namespace sandbox {
namespace {

/// A row of unit squares along u from `u0` on, `count` of them, that share their edges.
std::shared_ptr<const Mesh> strip(double u0, double v0, int count) {
    Mesh mesh;
    for (int i = 0; i <= count; ++i) {
        for (int j = 0; j <= 1; ++j) {
            mesh.positions.emplace_back(i, j, 0);
            mesh.normals.emplace_back(0, 0, 1);
            mesh.uvs.emplace_back(u0 + i, v0 + j);
        }
    }
    for (unsigned i = 0; i < static_cast<unsigned>(count); ++i) {
        mesh.triangles.emplace_back(2 * i, 2 * i + 2, 2 * i + 3);
        mesh.triangles.emplace_back(2 * i, 2 * i + 3, 2 * i + 1);
    }
    return std::make_shared<const Mesh>(mesh);
}

/// Every triangle is where it was, and its coordinates differ by one multiple of `step` for all three corners.
void expect_same_picture(const Mesh &given, const Mesh &near, double step = uv_step) {
    ASSERT_EQ(near.triangles.size(), given.triangles.size());
    EXPECT_EQ(near.positions.size(), near.uvs.size());
    EXPECT_EQ(near.positions.size(), near.normals.size());
    for (std::size_t i = 0; i < given.triangles.size(); ++i) {
        const glm::uvec3 &a = given.triangles[i];
        const glm::uvec3 &b = near.triangles[i];
        const glm::dvec2 offset = given.uvs[a.x] - near.uvs[b.x];
        EXPECT_EQ(offset, step * glm::round(offset / step));
        for (int corner = 0; corner < 3; ++corner) {
            EXPECT_EQ(given.positions[a[corner]], near.positions[b[corner]]);
            EXPECT_EQ(given.uvs[a[corner]] - near.uvs[b[corner]], offset) << "exact: nothing is rounded";
        }
    }
}

TEST(NearUvs, OrdinaryMeshesAreThemselves) {
    for (const Shape &shape : {Shape(SphereShape{}), Shape(BoxShape{}), Shape(TorusShape{}), Shape(CylinderShape{})}) {
        const auto mesh = std::make_shared<const Mesh>(build_mesh(shape));
        EXPECT_EQ(with_near_uvs(mesh), mesh);
    }
    for (const auto &mesh : {strip(-7, 0, 14), strip(0, -8, 1)}) {
        EXPECT_EQ(with_near_uvs(mesh), mesh) << "a few repeats about 0";
    }
    const auto bare = std::make_shared<const Mesh>(read_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3", "a.obj"));
    EXPECT_EQ(with_near_uvs(bare), bare);
}

TEST(NearUvs, FarCoordinatesComeNearAndKeepTheirVertices) {
    const auto given = strip(500000, 5e6, 1);
    const auto near = with_near_uvs(given);
    expect_same_picture(*given, *near);
    EXPECT_EQ(near->positions.size(), 4U);
    for (const glm::dvec2 &uv : near->uvs) {
        EXPECT_LE(std::abs(uv.x), uv_step / 2 + 0.5);
        EXPECT_LE(std::abs(uv.y), uv_step / 2 + 0.5);
    }
}

/// 100 squares along u: 50 to 150 and, in the same mesh, the offset changes every uv_step squares; only there is an
/// edge split, on average one in uv_step.
TEST(NearUvs, VerticesGoApartOnlyWhereOffsetsDiffer) {
    const auto given = strip(50, 0, 100);
    const auto near = with_near_uvs(given);
    expect_same_picture(*given, *near);
    EXPECT_GT(near->positions.size(), given->positions.size());
    EXPECT_LE(near->positions.size(), given->positions.size() + 2 * (100 / static_cast<std::size_t>(uv_step) + 1));
    for (std::size_t i = 0; i < near->uvs.size(); ++i) {
        EXPECT_LE(std::abs(near->uvs[i].x), uv_step / 2 + 0.5);
    }
}

/// Strips of 8 squares: 3 and 2 repeats a square, within half a repeat and half a square of 0.
TEST(NearUvs, RepeatsMultiplyCoordinatesAndStayNear) {
    const auto given = strip(0, 0, 8);
    Mesh multiplied = *given;
    for (glm::dvec2 &uv : multiplied.uvs) {
        uv *= glm::dvec2(3, 2);
    }
    const auto repeated = with_repeated_uvs(given, {3, 2});
    expect_same_picture(multiplied, *repeated, 1);
    for (const glm::dvec2 &uv : repeated->uvs) {
        EXPECT_LE(std::abs(uv.x), 0.5 + 1.5);
        EXPECT_LE(std::abs(uv.y), 0.5 + 1);
    }
    EXPECT_EQ(with_repeated_uvs(given, {1, 1}), given);
}

TEST(NearUvs, OneMeshMayHoldNearAndFarTriangles) {
    const std::string text =
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.25 0.5\nvt 1 0\nvt 0 1\nvt 1e6 0\nvt 1000001 0\nvt 1e6 1\n"
        "f 1/1 2/2 3/3\nf 1/4 2/5 3/6\nf 1/1 2/5 3/3\n";
    const auto given = std::make_shared<const Mesh>(read_obj(text, "a.obj"));
    const auto near = with_near_uvs(given);
    expect_same_picture(*given, *near);
    EXPECT_EQ(near->uvs[near->triangles[0].x], glm::dvec2(0.25, 0.5)) << "what is near stays";
    EXPECT_EQ(near->uvs[near->triangles[1].y], glm::dvec2(1, 0));
    // The third spans a million repeats: only its middle can come near 0.
    EXPECT_NEAR(near->uvs[near->triangles[2].x].x, -5e5, uv_step);
}

} // namespace
} // namespace sandbox

#include "reference/analytic.h"

#include "reference/lighting.h"
#include "reference/quartic.h"
#include "reference/reference_scenes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <random>

namespace sandbox::reference {
namespace {

Roots quartic_of(double a, double b, double c) {
    // (x - a)(x - b)(x - c)(x + a + b + c): no cubic term.
    const double d = -(a + b + c);
    const double p = a * b + a * c + a * d + b * c + b * d + c * d;
    const double q = -(a * b * c + a * b * d + a * c * d + b * c * d);
    return depressed_quartic_roots(p, q, a * b * c * d, 100);
}

TEST(Quartic, FindsFourRootsInOrder) {
    const Roots roots = quartic_of(-3, 1, 7);
    ASSERT_EQ(roots.count, 4);
    const double expected[] = {-5, -3, 1, 7};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(roots.values[i], expected[i], 1e-12);
    }
}

TEST(Quartic, TwoRootsNoneAndCloseOnes) {
    EXPECT_EQ(depressed_quartic_roots(0, 0, 1, 10).count, 0);
    const Roots two = depressed_quartic_roots(0, 0, -16, 10);
    ASSERT_EQ(two.count, 2);
    EXPECT_NEAR(two.values[1], 2, 1e-15);
    const Roots close = quartic_of(1, 1 + 1e-5, 3);
    ASSERT_EQ(close.count, 4);
    EXPECT_NEAR(close.values[2] - close.values[1], 1e-5, 1e-9); // a gap g between roots carries 1e-16 / g
}

struct Case {
    Shape shape;
    double (*outside)(const glm::dvec3 &); ///< 0 on the surface
};

/// Every hit lies on the shape, and rays towards points of the surface from outside are not missed.
TEST(Analytic, HitsLieOnTheSurfaceWithItsNormal) {
    const Case cases[] = {
        {SphereShape{1.5, 8, 16}, [](const glm::dvec3 &p) { return glm::length(p) - 1.5; }},
        {BoxShape{{1, 2, 3}, 1},
         [](const glm::dvec3 &p) {
             return std::max({std::abs(p.x) - 0.5, std::abs(p.y) - 1, std::abs(p.z) - 1.5});
         }},
        {CylinderShape{0.5, 2, 16, 1, true},
         [](const glm::dvec3 &p) { return std::max(std::hypot(p.x, p.z) - 0.5, std::abs(p.y) - 1); }},
        {TorusShape{1, 0.4, 16, 8},
         [](const glm::dvec3 &p) { return std::hypot(std::hypot(p.x, p.z) - 1, p.y) - 0.4; }},
    };
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    for (const Case &c : cases) {
        int hits = 0;
        for (int i = 0; i < 2000; ++i) {
            const glm::dvec3 origin = 5.0 * unit({normal(random), normal(random), normal(random)});
            const glm::dvec3 target(normal(random), normal(random), normal(random));
            const auto hit = intersect(c.shape, origin, target - origin, 0, 1e9);
            if (!hit) {
                continue;
            }
            ++hits;
            EXPECT_NEAR(c.outside(hit->position), 0, 1e-13);
            EXPECT_NEAR(glm::length(origin + hit->t * (target - origin) - hit->position), 0, 1e-7);
            EXPECT_LT(glm::dot(hit->normal, target - origin), 1e-6); // from outside only front faces are seen
            EXPECT_NEAR(glm::length(hit->normal), 1, 1e-14);
            // The normal is the gradient: stepping along it leaves the surface at full speed.
            EXPECT_NEAR(c.outside(hit->position + 1e-6 * hit->normal), 1e-6, 1e-11);
        }
        EXPECT_GT(hits, 500);
    }
}

TEST(Analytic, UvsAreThoseOfTheMesh) {
    // At the vertices of the mesh, looked at from outside, the shape has the mesh's own uv, position and normal.
    const Shape shapes[] = {SphereShape{1, 8, 16}, BoxShape{{1, 2, 3}, 3}, PlaneShape{{2, 4}, 4},
                            CylinderShape{0.5, 2, 16, 4, true}, TorusShape{1, 0.4, 16, 8}};
    for (const Shape &shape : shapes) {
        const Mesh mesh = build_mesh(shape);
        for (const glm::uvec3 &t : mesh.triangles) {
            // The middle of a triangle, pushed out, hits near; uvs are linear on flat faces and nearly so elsewhere.
            const glm::dvec3 p = (mesh.positions[t.x] + mesh.positions[t.y] + mesh.positions[t.z]) / 3.0;
            const glm::dvec3 n = unit(mesh.normals[t.x] + mesh.normals[t.y] + mesh.normals[t.z]);
            const glm::dvec2 uv = (mesh.uvs[t.x] + mesh.uvs[t.y] + mesh.uvs[t.z]) / 3.0;
            const auto hit = intersect(shape, p + 0.5 * n, -n, 0, 1);
            ASSERT_TRUE(hit.has_value());
            EXPECT_GT(glm::dot(hit->normal, n), 0.95);
            EXPECT_LT(glm::length(hit->position - p), 0.1);
            EXPECT_LT(glm::length(hit->uv - uv), 0.04) << shape.index() << ' ' << uv.x << ' ' << uv.y;
        }
    }
}

TEST(Analytic, FromInsideTheFarWallIsSeen) {
    const auto sphere = intersect(SphereShape{}, {0, 0, 0.5}, {0, 0, -1}, 0.1, 100);
    ASSERT_TRUE(sphere.has_value());
    EXPECT_DOUBLE_EQ(sphere->t, 1.5);
    EXPECT_EQ(sphere->normal, glm::dvec3(0, 0, -1)); // outward still
    const auto box = intersect(BoxShape{}, {0, 0, 0}, {0, 1, 0}, 0.1, 100);
    ASSERT_TRUE(box.has_value());
    EXPECT_DOUBLE_EQ(box->t, 0.5);
    EXPECT_FALSE(intersect(SphereShape{}, {0, 0, 5}, {0, 0, 1}, 0, 100).has_value());
    EXPECT_FALSE(intersect(SphereShape{}, {0, 0, 5}, {0, 0, -1}, 0, 3.9).has_value()); // beyond the far plane
}

TEST(Analytic, ATubeWithoutCapsIsOpen) {
    const CylinderShape tube{0.5, 1, 16, 1, false};
    EXPECT_FALSE(intersect(tube, {0, 5, 0}, {0, -1, 0}, 0, 100).has_value());
    const auto inside = intersect(tube, {0, 3, 0}, {0.15, -1, 0}, 0, 100);
    ASSERT_TRUE(inside.has_value());
    EXPECT_NEAR(inside->position.x, 0.5, 1e-15);
    EXPECT_GT(glm::dot(inside->normal, {0.15, -1, 0}), 0); // seen from within
}

TEST(Analytic, GrazingTheTorusHitsItOnTheRim) {
    // The hole's rim and the outer rim, a hair inside and a hair outside.
    for (const double radius : {0.6, 1.4}) {
        const double in = radius < 1 ? 1e-6 : -1e-6;
        EXPECT_TRUE(intersect(TorusShape{}, {radius + in, 5, 0}, {0, -1, 0}, 0, 100).has_value());
        EXPECT_FALSE(intersect(TorusShape{}, {radius - in, 5, 0}, {0, -1, 0}, 0, 100).has_value());
    }
}

/// A plane is its mesh: the pictures agree to rounding, the texture's repeats included.
TEST(Analytic, ATextureRepeatsAsOnTheMesh) {
    Scene scene = test::ball({2, 3, 5});
    scene.objects[0] = test::object_of(PlaneShape{});
    scene.objects[0].transform.rotate_degrees = {60, 0, 0};
    scene.objects[0].material.texture = "tiles.png";
    scene.objects[0].material.texture_repeat = {3, 2};
    const auto resources = Resources(Assets("assets")).load(scene);
    const Size size{80, 80};
    const ReferenceFrame mesh = render_reference(scene, resources, {}, size);
    const ReferenceFrame exact = render_reference(scene, resources, {}, size, Surface::analytic);
    int compared = 0;
    for (std::size_t i = 0; i < mesh.color.size(); ++i) {
        if (mesh.object_ids[i] == 1 && exact.object_ids[i] == 1) {
            ++compared;
            EXPECT_NEAR(glm::length(mesh.color[i] - exact.color[i]), 0, 1e-9);
        }
    }
    EXPECT_GT(compared, 500);
}

TEST(Analytic, MeshAndShapeMeetInEveryTransform) {
    const Shape shapes[] = {SphereShape{1, 64, 128}, BoxShape{}, CylinderShape{0.5, 1, 128, 1, true},
                            TorusShape{1, 0.4, 128, 64}};
    for (const Shape &shape : shapes) {
        for (const glm::dvec3 scale : {glm::dvec3(1), glm::dvec3(0.5, 1.5, -0.8)}) {
            Scene scene = test::ball({2, 3, 5});
            scene.objects[0] = test::object_of(shape);
            scene.objects[0].transform = {{0.1, 0.2, 0}, {30, -50, 70}, scale};
            const Size size{80, 80};
            const ReferenceFrame mesh = test::render(scene, {}, size);
            const ReferenceFrame exact = test::render(scene, {}, size, Surface::analytic);
            int compared = 0;
            double sum = 0;
            for (std::size_t i = 0; i < mesh.color.size(); ++i) {
                if (mesh.object_ids[i] == 1 && exact.object_ids[i] == 1) {
                    ++compared;
                    sum += glm::length(mesh.color[i] - exact.color[i]);
                }
            }
            EXPECT_GT(compared, 300);
            EXPECT_LT(sum / compared, 0.003) << shape.index();
        }
    }
}

} // namespace
} // namespace sandbox::reference

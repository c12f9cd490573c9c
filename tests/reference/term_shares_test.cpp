#include "reference/term_shares.h"

#include "reference/reference_scenes.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace sandbox {
namespace {

/// A dozen additions of numbers near 1, in double.
constexpr double tight = 1e-13;

Scene lit_ball() {
    Scene scene;
    scene.camera.position = {0, 1, 4};
    scene.ambient = glm::dvec3(0.05, 0.1, 0.15);
    Object ball = test::object_of(SphereShape{1, 6, 9});
    ball.material.emission = glm::dvec3(0.01, 0.02, 0.03);
    scene.objects.push_back(ball);
    for (const double x : {-3.0, 2.0}) {
        Light light = test::point_light({x, 2, 3});
        light.color = {1, 0.5, 0.25};
        light.ambient = 0.1;
        light.diffuse = 0.6;
        light.specular = x > 0 ? 0.8 : 0;
        scene.lights.push_back(light);
    }
    return scene;
}

TEST(TermShares, AddUpToThePixelUnderEveryFrequency) {
    const Scene scene = lit_ball();
    const auto loaded = test::resources_of(scene);
    for (const char *technique : {"flat/phong", "per-vertex/blinn-phong", "per-pixel/phong", "hybrid/blinn-phong",
                                  "per-pixel/phong:ambient=where-lit", "per-vertex/lambert"}) {
        const Technique t = parse_technique(technique);
        const Size size{40, 30};
        const auto probe = probe_pixel(scene, loaded, t, size, 21, 14);
        ASSERT_TRUE(probe) << technique;
        glm::dvec3 sum(0);
        const auto shares = term_shares(scene, loaded, t, size, 21, 14);
        EXPECT_EQ(shares.size(), 6U) << "the scene's own, ambient and diffuse of two lights, specular of one";
        for (const TermShare &share : shares) {
            sum += share.color;
        }
        EXPECT_NEAR(glm::length(sum - probe->color), 0, tight) << technique;
    }
}

TEST(TermShares, PerVertexLosesTheHighlightThatPerPixelHas) {
    const Scene scene = lit_ball();
    const auto loaded = test::resources_of(scene);
    double most = 0;
    for (int x = 10; x < 30; ++x) {
        const auto share = [&](const char *technique) {
            const auto shares = term_shares(scene, loaded, parse_technique(technique), {40, 30}, x, 10);
            return shares.empty() ? 0 : shares.back().color.r;
        };
        most = std::max(most, std::abs(share("per-pixel/phong") - share("per-vertex/phong")));
    }
    EXPECT_GT(most, 0.02) << "five levels of a screen: it can be seen";
}

TEST(TermShares, TheBackgroundHasNone) {
    const Scene scene = lit_ball();
    EXPECT_TRUE(term_shares(scene, test::resources_of(scene), {}, {40, 30}, 0, 0).empty());
}

} // namespace
} // namespace sandbox

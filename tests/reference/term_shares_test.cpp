#include "reference/term_shares.h"

#include "reference/reference_scenes.h"

#include <algorithm>
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

TEST(TermRow, ItsTermsAddUpToTheReferencesRow) {
    const Scene scene = lit_ball();
    const auto loaded = test::resources_of(scene);
    const Size size{40, 30};
    for (const char *technique : {"flat/phong", "per-vertex/blinn-phong", "per-pixel/phong", "hybrid/blinn-phong",
                                  "per-pixel/phong:ambient=where-lit", "per-vertex/lambert"}) {
        const Technique t = parse_technique(technique);
        const ReferenceFrame frame = render_reference(scene, loaded, t, size);
        for (const int y : {3, 14, 29}) {
            const auto row = reference_row(scene, loaded, t, size, y);
            const auto ambient = term_row(scene, loaded, t, size, y, "ambient");
            const auto diffuse = term_row(scene, loaded, t, size, y, "diffuse");
            const auto specular = term_row(scene, loaded, t, size, y, "specular");
            ASSERT_EQ(row.size(), 40U);
            for (std::size_t x = 0; x < row.size(); ++x) {
                const std::size_t pixel = static_cast<std::size_t>(y) * 40 + x;
                ASSERT_EQ(row[x].has_value(), frame.object_ids[pixel] != 0);
                EXPECT_EQ(row[x].value_or(scene.background), frame.color[pixel]) << technique << ", " << x << ", " << y;
                const glm::dvec3 sum = ambient[x] + diffuse[x] + specular[x];
                EXPECT_NEAR(glm::length(sum - row[x].value_or(glm::dvec3(0))), 0, tight) << technique << ", " << x;
            }
        }
    }
}

/// One light on a square that faces it and the eye: N = L = V = H, so each term is its intensity times its colour.
TEST(TermRow, OfASquareThatFacesTheLightIsItsClosedForm) {
    Scene scene;
    scene.camera.position = {0, 0, 4};
    scene.ambient = glm::dvec3(0.03);
    Object square = test::object_of(PlaneShape{});
    square.transform.rotate_degrees = {90, 0, 0};
    scene.objects.push_back(square);
    Light light;
    light.type = LightType::directional;
    light.direction = {0, 0, -1};
    light.ambient = 0.25;
    light.diffuse = 0.5;
    light.specular = 0;
    scene.lights = {light, light};
    scene.lights[1].enabled = false;
    const auto loaded = test::resources_of(scene);
    const Material &m = square.material;
    const glm::dvec3 l = light.color;
    const auto middle = [&](const char *term) {
        return term_row(scene, loaded, parse_technique("per-pixel/blinn-phong"), {41, 31}, 15, term)[20];
    };
    EXPECT_NEAR(glm::length(middle("ambient") - m.ambient * (scene.ambient + 0.25 * l)), 0, tight);
    EXPECT_NEAR(glm::length(middle("diffuse") - 0.5 * m.diffuse * l), 0, tight);
    EXPECT_EQ(middle("specular"), glm::dvec3(0)) << "the light has none";
}

} // namespace
} // namespace sandbox

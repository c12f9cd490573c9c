#include "tools/english.h"
#include "ui/session/pixel_findings.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace sandbox {
namespace {

/// A floor seen from above at an angle, and a light over it.
SidesShown floor_shown(const char *left, const char *right) {
    SidesShown shown;
    shown.scene.camera.position = {0, 3, 3};
    Object floor;
    floor.mesh = PlaneShape{};
    shown.scene.objects.push_back(floor);
    Light light;
    light.type = LightType::point;
    light.position = {0, 1, 0};
    shown.scene.lights.push_back(light);
    shown.left = parse_technique(left);
    shown.right = parse_technique(right);
    shown.size = {41, 41};
    return shown;
}

SideResources resources_of(const SidesShown &shown) {
    const auto of = [&](bool right) {
        const auto mesh = std::make_shared<const Mesh>(build_mesh(shown.scene_of(right).objects[0].mesh));
        return std::vector<ObjectResources>{{mesh, nullptr}};
    };
    return {of(false), of(true)};
}

TEST(PixelFindings, TheCentreOfAFloorHasTheVectorsOfAnyTextbook) {
    const SidesShown shown = floor_shown("per-vertex/blinn-phong", "per-pixel/blinn-phong");
    const PixelFindings found = probe_sides(shown, resources_of(shown), 20, 20);
    const auto &truth = found[Probed::truth_of_a];
    ASSERT_TRUE(truth && found[Probed::a] && found[Probed::b]);
    EXPECT_NEAR(glm::length(truth->probe.position), 0, 1e-12) << "the camera looks at the origin";
    EXPECT_NEAR(glm::distance(truth->probe.view, glm::normalize(glm::dvec3(0, 1, 1))), 0, 1e-12);
    EXPECT_NEAR(truth->probe.lights[0].terms.n_dot_l, 1, 1e-12);
    EXPECT_EQ(worst_term(english, *found[Probed::b], *truth), "") << "per pixel is the truth";
    const std::string worst = worst_term(english, *found[Probed::a], *truth);
    EXPECT_EQ(worst, "light 1, diffuse: red 0.577, should be 1") << "N.L at the four corners is 1 / sqrt 3";
}

TEST(PixelFindings, EachSideHasItsOwnMesh) {
    SidesShown shown = floor_shown("per-vertex/blinn-phong", "per-vertex/blinn-phong");
    EXPECT_TRUE(shown.one_truth());
    shown.mesh_factors = {1, 2};
    EXPECT_FALSE(shown.one_truth());
    const PixelFindings found = probe_sides(shown, resources_of(shown), 20, 20);
    ASSERT_TRUE(found[Probed::a] && found[Probed::b] && found[Probed::truth_of_b]);
    EXPECT_EQ(worst_term(english, *found[Probed::b], *found[Probed::truth_of_b]), "")
        << "two divisions: a vertex under the light";
    EXPECT_EQ(worst_term(english, *found[Probed::a], *found[Probed::truth_of_a]),
              "light 1, diffuse: red 0.577, should be 1")
        << "its only vertices are the corners";
}

TEST(PixelFindings, RowsNameEveryTermAndCopyAsATable) {
    const SidesShown shown = floor_shown("per-pixel/phong", "per-pixel/lambert");
    const PixelFindings found = probe_sides(shown, resources_of(shown), 20, 20);
    const std::string text = probe_text(english, found);
    for (const char *title : {"colour\t", "N\t", "V\t", "light 1: L\t", "light 1: attenuation a\t", "light 1: R\t",
                              "light 1: f^n\t", "light 1: specular share\t"}) {
        EXPECT_NE(text.find(title), std::string::npos) << title;
    }
    EXPECT_EQ(text.find("light 1: H"), std::string::npos) << "no Blinn-Phong here";
    EXPECT_EQ(text.find("cone"), std::string::npos);
}

TEST(PixelFindings, TheBackgroundHasNone) {
    SidesShown shown = floor_shown("flat/phong", "per-pixel/phong");
    shown.scene.camera.position = {0, 3, 30};
    const PixelFindings found = probe_sides(shown, resources_of(shown), 0, 0);
    EXPECT_FALSE(found[Probed::a] || found[Probed::truth_of_b]);
}

} // namespace
} // namespace sandbox

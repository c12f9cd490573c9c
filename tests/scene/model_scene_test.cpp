#include "scene/model_scene.h"

#include "scene/mesh.h"
#include "scene/space.h"
#include "tools/temporary_folder.h"

#include <array>
#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <string>

namespace sandbox {
namespace {

constexpr std::array<const char *, 6> outward{"f 5 6 7 8\n", "f 2 1 4 3\n", "f 6 2 3 7\n",
                                              "f 1 5 8 4\n", "f 8 7 3 4\n", "f 1 2 6 5\n"};

std::string corners(const glm::dvec3 &half, const glm::dvec3 &middle = glm::dvec3(0)) {
    std::string text;
    for (const glm::dvec3 &sign : {glm::dvec3{-1, -1, -1},
                                   {1, -1, -1},
                                   {1, 1, -1},
                                   {-1, 1, -1}, //
                                   glm::dvec3{-1, -1, 1},
                                   {1, -1, 1},
                                   {1, 1, 1},
                                   {-1, 1, 1}}) {
        const glm::dvec3 at = middle + sign * half;
        text += fmt::format("v {} {} {}\n", at.x, at.y, at.z);
    }
    return text;
}

std::string box(const glm::dvec3 &half) { return corners(half) + fmt::format("{}", fmt::join(outward, "")); }

class ModelScene : public testing::Test {
  protected:
    TemporaryFolder folder_;

    Scene open(const std::string &text, double aspect = unknown_aspect) {
        folder_.write("a.obj", text);
        return scene_of_model(folder_.path() / "a.obj", aspect);
    }
};

/// How far from the middle of a view the box reaches to the side and up: 1 is its edge.
glm::dvec2 reach(const Camera &camera, double aspect, const glm::dvec3 &half) {
    glm::dvec2 most(0);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 sign((corner & 1) - 0.5, (corner >> 1 & 1) - 0.5, (corner >> 2) - 0.5);
        const auto place = place_in_view(camera, aspect, 2.0 * sign * half - camera.position);
        EXPECT_TRUE(place.has_value()) << "behind the eye";
        most = glm::max(most, glm::abs(2.0 * place.value_or(glm::dvec2(9)) - 1.0));
    }
    return most;
}

TEST_F(ModelScene, ShowsTheWholeModelInViewsOfItsAspect) {
    for (const glm::dvec3 &half :
         {glm::dvec3{1, 1, 1}, {8, 1, 1}, {1, 8, 1}, {1, 1, 8}, {8, 8, 1}, {1e-6, 1e-5, 1e-6}, {1e5, 1e4, 1e3}}) {
        for (const double aspect : {0.1, 2.0 / 3, 1.0, 1.2, 16.0 / 9, 5.0}) {
            const Camera camera = open(box(half), aspect).camera;
            const glm::dvec2 most = reach(camera, aspect, half);
            EXPECT_LE(most.x, 0.95 + 1e-9)
                << aspect; // what the camera keeps free; rounding of the way back from a share
            EXPECT_LE(most.y, 1) << aspect;
            EXPECT_GT(camera.far_plane, glm::length(camera.position) + glm::length(half));
            EXPECT_LT(camera.near_plane, glm::length(camera.position) - glm::length(half));
        }
    }
}

/// From the ball around a model the same as ever, unless the view is too narrow; then as near as shows it all.
TEST_F(ModelScene, GoesBackOnlyForNarrowViews) {
    const glm::dvec3 wide(8, 1, 1);
    const auto distance = [&](double aspect) { return glm::length(open(box(wide), aspect).camera.position); };
    EXPECT_DOUBLE_EQ(distance(4), distance(2));
    EXPECT_GT(distance(2.0 / 3), distance(2));
    EXPECT_NEAR(reach(open(box(wide), 2.0 / 3).camera, 2.0 / 3, wide).x, 0.95, 1e-9);
}

/// What is seen of an opened model is lit, whichever way round its triangles run.
TEST_F(ModelScene, LightsBothSidesWhereBacksAreSeen) {
    const auto two_sided = [&](const std::string &text) { return open(text).objects.at(0).two_sided; };
    const std::string cube = corners(glm::dvec3(1));
    EXPECT_FALSE(two_sided(box(glm::dvec3(1))));
    EXPECT_TRUE(two_sided(cube + "f 5 6 7 8")) << "open";
    EXPECT_TRUE(two_sided(cube + "f 8 7 6 5\nf 3 4 1 2\nf 7 3 2 6\nf 4 8 5 1\nf 4 3 7 8\nf 5 6 2 1")) << "inside out";
    EXPECT_FALSE(two_sided(cube + "vn 0 0 1\nf 8//1 7//1 6//1 5//1")) << "its normals say where the front is";
}

TEST_F(ModelScene, KnowsModelsByTheirEnding) {
    EXPECT_TRUE(is_model("a.obj"));
    EXPECT_TRUE(is_model("b/a.OBJ"));
    EXPECT_FALSE(is_model("a.json"));
    EXPECT_FALSE(is_model("obj"));
}

} // namespace
} // namespace sandbox

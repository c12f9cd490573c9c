#include "scene/lone_sphere.h"

#include "image/error.h"
#include "scene/scene_file.h"
#include "scene/space.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

namespace sandbox {
namespace {

std::vector<ObjectResources> load(const Scene &scene) { return Resources(Assets("assets")).load(scene); }

Scene box_and_ball() {
    Scene scene;
    scene.lights = {Light{}};
    scene.lights[0].position = {0, 0, 10};
    scene.lights[0].specular = 0.3;
    scene.objects = {{"box", BoxShape{{2, 4, 6}, 1}, {.translate = {1, 0, 0}}, {}, false},
                     {"ball", SphereShape{2, 8, 16}, {.translate = {3, 0, -1}, .scale = {0.5, 0.5, 0.5}}, {}, false}};
    scene.camera.position = {3, 0, 9};
    return scene;
}

const SphereShape &shape_of(const LoneSphere &sphere) { return std::get<SphereShape>(sphere.scene.objects[0].mesh); }

TEST(LoneSphere, IsTheScenesOwnUnderItsLights) {
    const Scene scene = box_and_ball();
    const LoneSphere sphere = lone_sphere(scene, load(scene));
    ASSERT_EQ(sphere.scene.objects.size(), 1U);
    EXPECT_TRUE(sphere.own);
    EXPECT_FALSE(sphere.made_shiny);
    EXPECT_EQ(sphere.of, "ball");
    EXPECT_EQ(sphere.scene.lights, scene.lights);
    EXPECT_EQ(sphere.scene.objects[0].transform, scene.objects[1].transform);
    EXPECT_EQ(shape_of(sphere).radius, 2);
    EXPECT_EQ(shape_of(sphere).rings, 64);
}

/// Radius 1 at distance 10: the outline is seen at asin(1/10), and it fills 0.88 of half the height.
TEST(LoneSphere, IsSeenFromTheSamePlaceZoomedIn) {
    const Scene scene = box_and_ball();
    const Camera camera = lone_sphere(scene, load(scene)).scene.camera;
    EXPECT_EQ(camera.position, scene.camera.position);
    EXPECT_EQ(camera.target, glm::dvec3(3, 0, -1));
    const double outline = std::tan(std::asin(0.1));
    EXPECT_NEAR(std::tan(glm::radians(camera.fov_y_degrees) / 2) * 0.88, outline, 1e-12);
}

TEST(LoneSphere, AnEllipsoidIsNone) {
    Scene scene = box_and_ball();
    scene.objects[1].transform.scale = {1, 2, 1};
    const LoneSphere sphere = lone_sphere(scene, load(scene));
    EXPECT_FALSE(sphere.own);
    EXPECT_EQ(sphere.of, "box");
    EXPECT_EQ(sphere.scene.objects[0].transform.translate, glm::dvec3(1, 0, 0)) << "in the box's place";
    EXPECT_EQ(shape_of(sphere).radius, 2) << "half of the middle one of 2, 4 and 6";
}

TEST(LoneSphere, KeepsClearOfLampsAndTheEye) {
    Scene scene = box_and_ball();
    scene.objects.pop_back();
    scene.lights[0].position = {1, 0, 1};
    EXPECT_EQ(shape_of(lone_sphere(scene, load(scene))).radius, 0.5) << "half way to the lamp";
    scene.lights[0].enabled = false;
    EXPECT_EQ(shape_of(lone_sphere(scene, load(scene))).radius, 2);
}

TEST(LoneSphere, IsMadeShinyWhereNothingIs) {
    Scene scene = box_and_ball();
    scene.lights[0].specular = 0;
    const LoneSphere sphere = lone_sphere(scene, load(scene));
    EXPECT_TRUE(sphere.made_shiny);
    EXPECT_EQ(sphere.scene.lights[0].specular, 1);
    EXPECT_EQ(sphere.scene.objects[0].material.specular, glm::dvec3(0.5));
}

TEST(LoneSphere, AnEyeWithinItStepsBack) {
    Scene scene = box_and_ball();
    scene.camera.position = {3, 0.5, -1};
    const Camera camera = lone_sphere(scene, load(scene)).scene.camera;
    EXPECT_NEAR(glm::distance(camera.position, glm::dvec3(3, 0, -1)), 2, 1e-12);
    EXPECT_LT(camera.near_plane, 1);
}

TEST(LoneSphere, UnderAnOrthographicCameraTheHeightFits) {
    Scene scene = box_and_ball();
    scene.camera.projection = Projection::orthographic;
    scene.camera.height = 20;
    const Camera camera = lone_sphere(scene, load(scene)).scene.camera;
    EXPECT_NEAR(camera.height, 2 / 0.88, 1e-12);
    const auto middle = place_in_view(camera, 1, glm::dvec3(3, 0, -1) - camera.position);
    ASSERT_TRUE(middle);
    EXPECT_NEAR(middle->x, 0.5, 1e-12);
}

/// What the figures' sidecars hold is read back.
TEST(LoneSphere, EveryBuiltInSceneHasOneThatSceneFilesCanSay) {
    const Assets assets("assets");
    for (const std::string &name : builtin_scenes(assets)) {
        const Scene scene = open_scene(name, assets);
        const LoneSphere sphere = lone_sphere(scene, load(scene));
        EXPECT_EQ(parse_scene(scene_text(sphere.scene), name, "/"), sphere.scene) << name;
    }
}

TEST(LoneSphere, NeedsAnObject) { EXPECT_THROW(lone_sphere({}, {}), InputError); }

} // namespace
} // namespace sandbox

#include "scene/motion.h"

#include "image/error.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace sandbox {
namespace {

constexpr double rounding = 1e-12; // a few dozen double operations on numbers near 10

Scene lit_ball() {
    Scene scene;
    scene.camera.position = {0, 2, 5};
    scene.camera.target = {1, 0, 0};
    Light light;
    light.type = LightType::spot;
    light.position = {3, 4, 0};
    light.direction = {-1, -2, 0};
    scene.lights.push_back(light);
    scene.objects.push_back({.name = "ball", .mesh = SphereShape{}, .transform = {}, .material = {}});
    scene.objects[0].transform.rotate_degrees = {10, 20, 30};
    return scene;
}

std::vector<Motion> every_motion() {
    return {{.mover = Mover::camera},
            {.mover = Mover::light},
            {.mover = Mover::object},
            {.mover = Mover::camera, .to = 30, .course = Course::to_and_fro},
            {.mover = Mover::number, .path = "lights[0].diffuse", .from = 1, .to = 0, .course = Course::to_and_fro},
            {.mover = Mover::number, .path = "objects[0].material.shininess", .from = 32, .to = 128}};
}

TEST(Motion, BeginsWithTheSceneItselfAndRoundsRepeat) {
    for (const Motion &motion : every_motion()) {
        SCOPED_TRACE(motion_text(motion));
        const int round = moments_of(motion);
        EXPECT_EQ(round, 240) << "8 seconds of 30 moments";
        EXPECT_EQ(moved(lit_ball(), motion, 0), lit_ball());
        EXPECT_EQ(moved(lit_ball(), motion, round), lit_ball());
        EXPECT_EQ(moved(lit_ball(), motion, 17 - 3 * round), moved(lit_ball(), motion, 17));
        EXPECT_NE(moved(lit_ball(), motion, 17), lit_ball());
    }
}

TEST(Motion, GoesAtASteadySpeed) {
    const Motion turn{.from = 10, .to = 50, .seconds = 4};
    EXPECT_DOUBLE_EQ(value_at(turn, 30), 20);
    EXPECT_DOUBLE_EQ(value_at(turn, 90), 40);
    Motion fro = turn;
    fro.course = Course::to_and_fro;
    EXPECT_DOUBLE_EQ(value_at(fro, 30), 30);
    EXPECT_EQ(value_at(fro, 60), 50);
    EXPECT_DOUBLE_EQ(value_at(fro, 90), 30);
    EXPECT_EQ(moments_of({.seconds = 1e-9}), 2);
}

TEST(Motion, ALightsOrbitKeepsItsDistanceHeightAndAim) {
    const Scene scene = lit_ball();
    const glm::dvec3 from = scene.lights[0].position - scene.camera.target;
    for (int moment = 0; moment < 240; moment += 7) {
        const Light light = moved(scene, {}, moment).lights[0];
        const glm::dvec3 at = light.position - scene.camera.target;
        EXPECT_NEAR(glm::length(at), glm::length(from), rounding);
        EXPECT_NEAR(at.y, from.y, rounding);
        EXPECT_NEAR(glm::dot(glm::normalize(light.direction), glm::normalize(at)),
                    glm::dot(glm::normalize(scene.lights[0].direction), glm::normalize(from)), rounding);
    }
    const glm::dvec3 quarter = moved(scene, {}, 60).lights[0].position;
    EXPECT_NEAR(glm::distance(quarter, {1, 4, -2}), 0, rounding) << "counter-clockwise seen from above";
}

TEST(Motion, AnObjectTurnsOnTopOfItsScenesTurn) {
    const Scene turned = moved(lit_ball(), {.mover = Mover::object}, 60);
    EXPECT_EQ(turned.objects[0].transform.rotate_degrees, glm::dvec3(10, 110, 30));
}

TEST(Motion, EveryNumberWithAControlCanMove) {
    const Scene scene = lit_ball();
    const auto numbers = numbers_of(scene);
    const auto has = [&](const char *path) { return std::ranges::count(numbers, path, &SceneNumber::path) == 1; };
    for (const char *path : {"lights[0].diffuse", "lights[0].position[1]", "lights[0].attenuation.quadratic",
                             "objects[0].material.shininess", "objects[0].mesh.rings", "camera.fov_y_degrees",
                             "objects[0].transform.scale[2]", "ambient[0]"}) {
        EXPECT_TRUE(has(path)) << path;
    }
    EXPECT_FALSE(has("camera.height")) << "of an orthographic camera";
    for (const SceneNumber &number : numbers) {
        Motion still{.mover = Mover::number, .path = number.path, .from = number.value, .to = number.value};
        EXPECT_EQ(moved(scene, still, 1), scene) << number.path;
    }
    const Motion rings{.mover = Mover::number, .path = "objects[0].mesh.rings", .from = 4, .to = 5, .seconds = 1};
    EXPECT_EQ(std::get<SphereShape>(moved(scene, rings, 14).objects[0].mesh).rings, 4);
    EXPECT_EQ(std::get<SphereShape>(moved(scene, rings, 16).objects[0].mesh).rings, 5);
}

TEST(Motion, RefusesWhatIsNotThere) {
    EXPECT_THROW(moved(lit_ball(), {.mover = Mover::light, .index = 1}, 0), InputError);
    EXPECT_THROW(moved(lit_ball(), {.mover = Mover::object, .index = 1}, 0), InputError);
    EXPECT_THROW(moved(lit_ball(), {.mover = Mover::number, .path = "lights[1].diffuse"}, 0), InputError);
    EXPECT_THROW(moved(lit_ball(), {.mover = Mover::number, .path = "lights[0].diffuse", .from = -1}, 0), InputError);
}

TEST(Motion, TextsRoundTrip) {
    for (const Motion &motion : every_motion()) {
        EXPECT_EQ(parse_motion(motion_text(motion), "a.json"), motion);
    }
    for (const char *wrong : {R"([])", R"({"mover": "sun"})", R"({"mover": "light", "index": -1})",
                              R"({"mover": "camera", "from": 0, "to": 1, "seconds": 0, "course": "turn"})",
                              R"({"mover": "camera", "from": 0, "to": 1e300, "seconds": 1, "course": "turn"})"}) {
        EXPECT_THROW(parse_motion(wrong, "a.json"), InputError) << wrong;
    }
}

TEST(Motion, OrbitsAboutAFarTargetKeepTheirDigits) {
    Scene scene = lit_ball();
    scene.camera.position = {0, 2, 5};
    const Scene near = moved(scene, {.mover = Mover::light}, 60);
    scene.camera.target += glm::dvec3(1e8, 0, -1e8);
    scene.camera.position += glm::dvec3(1e8, 0, -1e8);
    scene.lights[0].position += glm::dvec3(1e8, 0, -1e8);
    const Scene far = moved(scene, {.mover = Mover::light}, 60);
    EXPECT_LT(glm::length(far.lights[0].direction - near.lights[0].direction), rounding) << "added to no place";
    scene.camera.target.x = scene.camera.position.x = -9e9;
    EXPECT_THROW(moved(scene, {.mover = Mover::light}, 60), InputError) << "18e9 away, where no light may be";
}

} // namespace
} // namespace sandbox

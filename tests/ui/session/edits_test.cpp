#include "scene/scene_file.h"
#include "ui/session/edits.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace sandbox {
namespace {

Scene one_object() {
    Scene scene;
    scene.objects = {Object{"ball", SphereShape{}, {}, {}, false}};
    return scene;
}

/// What the reader makes of it; throws if it refuses the scene.
Scene read_back(const Scene &scene) { return parse_scene(scene_text(scene), "edited.json", "."); }

const TechniqueKey &key_of(std::string_view name) {
    return *std::ranges::find(technique_keys(), name, &TechniqueKey::name);
}

TEST(Edits, LightsBesideAFarCameraAreWhereASceneFileCanSay) {
    Scene scene;
    scene.camera.position = {1e10, -1e10, 9e9};
    scene.camera.target = {-1e10, 1e10, 9e9};
    add_light(scene, LightType::point);
    EXPECT_EQ(read_back(scene), scene);
    scene.lights.emplace_back().type = LightType::directional;
    set_type(scene.lights.back(), LightType::point, scene.camera);
    EXPECT_EQ(read_back(scene), scene);
}

TEST(Edits, LightsAreAddedUpToEightOfEachType) {
    Scene scene = one_object();
    for (const LightType type : {LightType::directional, LightType::point, LightType::spot}) {
        for (int i = 0; i < 10; ++i) {
            add_light(scene, type);
        }
        EXPECT_EQ(count_lights(scene, type), most_lights_of_a_type);
        EXPECT_FALSE(can_add_light(scene, type));
    }
    EXPECT_EQ(scene.lights.size(), 24U);
    EXPECT_EQ(read_back(scene), scene);
}

TEST(Edits, NeverMoreLightsThanASceneFileHolds) {
    Scene scene = one_object();
    scene.lights.assign(64, Light{});
    add_light(scene, LightType::spot);
    EXPECT_EQ(scene.lights.size(), 64U);
}

TEST(Edits, ANewLightShinesOnTheTarget) {
    Scene scene = one_object();
    scene.camera.target = {3, 1, 0};
    add_light(scene, LightType::spot);
    const Light &light = scene.lights.back();
    const glm::dvec3 to_target = glm::normalize(scene.camera.target - light.position);
    EXPECT_NEAR(glm::dot(to_target, glm::normalize(light.direction)), 1, 1e-12);
    EXPECT_GT(light.position.y, scene.camera.target.y);
}

TEST(Edits, SwitchingATypeOnAddsOneWhereThereIsNone) {
    Scene scene = one_object();
    add_light(scene, LightType::point);
    add_light(scene, LightType::point);
    switch_lights(scene, LightType::point, false);
    EXPECT_TRUE(std::ranges::none_of(scene.lights, &Light::enabled));
    switch_lights(scene, LightType::spot, false);
    EXPECT_EQ(scene.lights.size(), 2U);
    switch_lights(scene, LightType::spot, true);
    EXPECT_EQ(count_lights(scene, LightType::spot), 1U);
    switch_lights(scene, LightType::point, true);
    EXPECT_TRUE(std::ranges::all_of(scene.lights, &Light::enabled));
    EXPECT_EQ(scene.lights.size(), 3U);
}

TEST(Edits, ALampThatBecomesDirectionalShinesOnTheTarget) {
    const Camera camera;
    Light light;
    light.position = {0, 0, 3};
    set_type(light, LightType::directional, camera);
    EXPECT_EQ(light.direction, glm::dvec3(0, 0, -1));
    light.direction = {0, 0, -2};
    set_type(light, LightType::spot, camera);
    EXPECT_EQ(light.position, glm::dvec3(0, 0, 3));
    EXPECT_EQ(light.direction, glm::dvec3(0, 0, -2));
}

TEST(Edits, ADirectionalThatBecomesALampStandsWhereItShoneFrom) {
    const Camera camera;
    Light light;
    light.type = LightType::directional;
    light.direction = {0, -2, 0};
    set_type(light, LightType::point, camera);
    EXPECT_GT(light.position.y, 1);
    EXPECT_EQ(light.position.x, 0);
}

TEST(Edits, TheInnerConeStaysInside) {
    Light light;
    light.type = LightType::spot;
    set_cutoff(light, 40); // a hard edge stays hard
    EXPECT_EQ(light.inner_cutoff_degrees, 40);
    light.inner_cutoff_degrees = 35;
    set_cutoff(light, 20);
    EXPECT_EQ(light.inner_cutoff_degrees, 20);
    set_cutoff(light, 120);
    EXPECT_EQ(light.cutoff_degrees, 90);
    set_cutoff(light, 180);
    EXPECT_EQ(light.cutoff_degrees, 180);
    set_cutoff(light, 30);
    EXPECT_LE(light.inner_cutoff_degrees, 30);
}

TEST(Edits, AttenuationIsNeverAllZero) {
    Attenuation attenuation{0, 0, 0};
    keep_attenuation_valid(attenuation);
    EXPECT_GT(attenuation.constant, 0);
    Attenuation fine{0, 0, 0.5};
    keep_attenuation_valid(fine);
    EXPECT_EQ(fine, (Attenuation{0, 0, 0.5}));
}

TEST(Edits, SlidersLeaveALightThatTheReaderAccepts) {
    Light light;
    light.type = LightType::spot;
    const Light before = light;
    light.direction = glm::dvec3(0);
    light.attenuation = {0, 0, 0};
    light.cutoff_degrees = 20;
    light.inner_cutoff_degrees = 50;
    keep_valid(light, before);
    Scene scene = one_object();
    scene.lights = {light};
    EXPECT_EQ(read_back(scene), scene);
    EXPECT_EQ(light.direction, before.direction);
    EXPECT_EQ(light.cutoff_degrees, 20);
}

TEST(Edits, SettingAKeyLeavesAValidTechnique) {
    Technique technique = parse_technique("per-pixel/blinn-phong:half_vector=constant,renormalize=off");
    set_key(technique, key_of("model"), static_cast<int>(Model::phong));
    EXPECT_EQ(to_string(technique), "per-pixel/phong:renormalize=off");
    set_key(technique, key_of("frequency"), static_cast<int>(Frequency::per_vertex));
    EXPECT_EQ(to_string(technique), "per-vertex/phong");
}

} // namespace
} // namespace sandbox

#include "ui/session/usable_controls.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace sandbox {
namespace {

const Technique lambert = parse_technique("per-pixel/lambert");
const Technique phong = parse_technique("per-pixel/phong");
const Technique blinn = parse_technique("per-pixel/blinn-phong");

Light light_of(LightType type) {
    Light light;
    light.type = type;
    return light;
}

Scene scene_with(const std::vector<Light> &lights) {
    Scene scene;
    scene.lights = lights;
    scene.objects = {Object{}};
    return scene;
}

/// Lights with all terms that fade, on an object that is moved, turned and squashed.
Scene scene_that_shows_all(const std::vector<LightType> &types) {
    Scene scene = scene_with({});
    scene.objects[0].transform = {{1, 0, 0}, {0, 30, 0}, {1, 2, 1}};
    for (const LightType type : types) {
        scene.lights.push_back(light_of(type));
        scene.lights.back().ambient = 0.1;
        scene.lights.back().attenuation.linear = 0.1;
    }
    return scene;
}

const TechniqueKey &key_of(std::string_view name) {
    return *std::ranges::find(technique_keys(), name, &TechniqueKey::name);
}

TEST(UsableControls, NoSpecularUnderLambertOnBothSides) {
    const Scene scene = scene_with({light_of(LightType::point)});
    EXPECT_FALSE(light_controls(scene.lights[0], lambert, lambert).specular);
    EXPECT_FALSE(material_controls(scene, 0, lambert, lambert).specular);
    EXPECT_FALSE(material_controls(scene, 0, lambert, lambert).shininess);
    for (const auto &[left, right] : {std::pair{lambert, phong}, std::pair{blinn, lambert}, std::pair{phong, blinn}}) {
        EXPECT_TRUE(light_controls(scene.lights[0], left, right).specular);
        EXPECT_TRUE(material_controls(scene, 0, left, right).specular);
        EXPECT_TRUE(material_controls(scene, 0, left, right).shininess);
    }
}

TEST(UsableControls, ATermAtZeroKeepsItsSlider) {
    Light dark = light_of(LightType::spot);
    dark.diffuse = dark.specular = dark.ambient = dark.exponent = 0;
    dark.color = {0, 0, 0};
    Scene scene = scene_with({dark});
    scene.objects[0].material.specular = {0, 0, 0};
    scene.objects[0].material.shininess = 0;
    EXPECT_EQ(light_controls(dark, phong, phong), light_controls(light_of(LightType::spot), phong, phong));
    EXPECT_TRUE(material_controls(scene, 0, phong, phong).specular);
    EXPECT_TRUE(material_controls(scene, 0, phong, phong).shininess);
    EXPECT_TRUE(material_controls(scene, 0, phong, phong).diffuse);
}

TEST(UsableControls, DirectionalHasNoPlaceAndDoesNotFade) {
    const LightControls can = light_controls(light_of(LightType::directional), phong, phong);
    EXPECT_TRUE(can.direction);
    EXPECT_FALSE(can.position);
    EXPECT_FALSE(can.attenuation);
    EXPECT_FALSE(can.attenuate_ambient);
    EXPECT_FALSE(can.cone);
}

TEST(UsableControls, PointHasNoDirectionAndNoCone) {
    const LightControls can = light_controls(light_of(LightType::point), phong, phong);
    EXPECT_TRUE(can.position);
    EXPECT_TRUE(can.attenuation);
    EXPECT_TRUE(can.attenuate_ambient);
    EXPECT_FALSE(can.direction);
    EXPECT_FALSE(can.cone);
    EXPECT_FALSE(can.cone_shape);
}

TEST(UsableControls, ASpotWithoutAConeIsAPointLight) {
    Light spot = light_of(LightType::spot);
    EXPECT_TRUE(light_controls(spot, phong, phong).cone_shape);
    EXPECT_TRUE(light_controls(spot, phong, phong).direction);
    spot.cutoff_degrees = 180;
    EXPECT_TRUE(light_controls(spot, phong, phong).cone); // to switch it on again
    EXPECT_FALSE(light_controls(spot, phong, phong).cone_shape);
    EXPECT_FALSE(light_controls(spot, phong, phong).direction);
}

TEST(UsableControls, ALightThatIsOffHasNone) {
    Light off = light_of(LightType::spot);
    off.enabled = false;
    EXPECT_EQ(light_controls(off, phong, blinn), LightControls{});
}

TEST(UsableControls, WithoutALightThatIsOnOnlyAmbientAndEmissionAreLeft) {
    Scene scene = scene_with({light_of(LightType::point)});
    scene.lights[0].enabled = false;
    EXPECT_EQ(material_controls(scene, 0, phong, blinn), MaterialControls{});
    EXPECT_EQ(scene_controls(scene, phong, blinn), SceneControls{});
}

TEST(UsableControls, BlinnScaleOnlyUnderBlinnPhong) {
    const Scene scene = scene_with({light_of(LightType::point)});
    EXPECT_FALSE(scene_controls(scene, phong, lambert).blinn_exponent_scale);
    EXPECT_TRUE(scene_controls(scene, phong, blinn).blinn_exponent_scale);
    EXPECT_TRUE(scene_controls(scene, blinn, lambert).blinn_exponent_scale);
}

TEST(UsableControls, ModulatingTheHighlightNeedsASurfaceAndAHighlight) {
    Scene scene = scene_with({light_of(LightType::point)});
    EXPECT_FALSE(material_controls(scene, 0, phong, phong).modulates_specular);
    scene.objects[0].material.texture = "checker.png";
    EXPECT_TRUE(material_controls(scene, 0, phong, phong).modulates_specular);
    EXPECT_FALSE(material_controls(scene, 0, lambert, lambert).modulates_specular);
    scene.objects[0].material.texture.clear();
    scene.objects[0].material.checker = Checker{};
    EXPECT_TRUE(material_controls(scene, 0, phong, phong).modulates_specular);
    EXPECT_TRUE(material_controls(scene, 0, phong, phong).checker);
}

TEST(UsableControls, KeysAreOfferedWhereTheSceneAsksForThem) {
    const Scene points = scene_that_shows_all({LightType::point});
    const Scene sun = scene_that_shows_all({LightType::directional});
    EXPECT_FALSE(value_open(key_of("direction"), 1, points, phong));
    EXPECT_TRUE(value_open(key_of("direction"), 1, sun, phong));
    EXPECT_TRUE(value_open(key_of("attenuation"), 1, points, phong));
    EXPECT_FALSE(value_open(key_of("attenuation"), 1, sun, phong));
    EXPECT_TRUE(value_open(key_of("viewer"), 1, sun, phong));
    EXPECT_FALSE(value_open(key_of("viewer"), 1, sun, lambert));
    EXPECT_FALSE(value_open(key_of("position"), 1, sun, lambert));
    EXPECT_TRUE(value_open(key_of("position"), 1, points, lambert));
    EXPECT_FALSE(value_open(key_of("power"), 1, points, lambert));
}

TEST(UsableControls, KeysAreNotOfferedWhereTheTechniqueRefusesThem) {
    const Scene scene = scene_that_shows_all({LightType::point});
    EXPECT_FALSE(value_open(key_of("half_vector"), 1, scene, phong));
    EXPECT_TRUE(value_open(key_of("half_vector"), 1, scene, blinn));
    EXPECT_FALSE(value_open(key_of("renormalize"), 1, scene, parse_technique("per-vertex/phong")));
    EXPECT_FALSE(value_open(key_of("gate"), 2, scene, lambert));
    EXPECT_FALSE(value_open(key_of("attenuation"), 2, scene, parse_technique("interpolated-vectors/phong")));
    EXPECT_FALSE(value_open(key_of("program"), 1, scene, parse_technique("per-pixel/phong:attenuation=interpolated")));
}

TEST(UsableControls, ValuesThatNothingShowsHaveNoEffect) {
    const auto use = [](const Scene &scene, std::string_view technique, std::string_view key, int value) {
        return value_use(key_of(key), value, scene, parse_technique(technique));
    };
    const std::string pixel = "per-pixel/phong";
    Scene scene = scene_that_shows_all({LightType::point});
    EXPECT_EQ(use(scene, "per-vertex/phong", "renormalize", 1), ValueUse::refused);
    for (const std::string_view key : {"normals", "position", "ambient", "attenuation", "viewer", "gate"}) {
        EXPECT_EQ(use(scene, pixel, key, 1), ValueUse::open) << key;
    }
    scene.objects[0].transform.scale = {2, 2, 2};
    EXPECT_EQ(use(scene, pixel, "normals", 1), ValueUse::no_effect);
    EXPECT_EQ(use(scene, pixel, "normals", 2), ValueUse::open) << "it is turned";
    scene.objects[0].transform = {};
    EXPECT_EQ(use(scene, pixel, "normals", 2), ValueUse::no_effect);
    EXPECT_EQ(use(scene, pixel, "position", 1), ValueUse::no_effect) << "it stands at the origin";
    scene.lights[0].ambient = 0;
    EXPECT_EQ(use(scene, pixel, "ambient", 1), ValueUse::no_effect);
    scene.lights[0].attenuation = {0.5, 0, 0};
    EXPECT_EQ(use(scene, pixel, "attenuation", 1), ValueUse::no_effect) << "the same at every distance";
    scene.objects[0].material.specular = {0, 0, 0};
    EXPECT_EQ(use(scene, pixel, "gate", 1), ValueUse::no_effect);
    EXPECT_EQ(use(scene, pixel, "viewer", 1), ValueUse::no_effect);
    scene.objects[0].two_sided = true;
    EXPECT_EQ(use(scene, pixel, "viewer", 1), ValueUse::open) << "V says which side is seen";
    EXPECT_EQ(use(scene, pixel, "power", 2), ValueUse::no_effect) << "no exponent is raised";
}

TEST(UsableControls, AValueThatIsSetCanBeSeenAndLeft) {
    const Scene sun = scene_with({light_of(LightType::directional)});
    const Technique technique = parse_technique("per-pixel/phong:attenuation=interpolated");
    EXPECT_TRUE(value_open(key_of("attenuation"), 1, sun, technique));
    EXPECT_FALSE(value_open(key_of("attenuation"), 2, sun, technique));
}

TEST(UsableControls, EveryOpenValueIsAValidTechnique) {
    const Scene scene = scene_that_shows_all({LightType::point, LightType::directional});
    int open = 0;
    for (const TechniqueKey &key : technique_keys()) {
        for (const Technique &from : {lambert, phong, blinn, parse_technique("flat/phong")}) {
            for (int value = 0; value < static_cast<int>(key.values.size()); ++value) {
                Technique changed = from;
                key.set(changed, value);
                if (value_open(key, value, scene, from)) {
                    ++open;
                    EXPECT_FALSE(why_refused(changed)) << to_string(changed);
                }
            }
        }
    }
    EXPECT_GT(open, 60);
}

} // namespace
} // namespace sandbox

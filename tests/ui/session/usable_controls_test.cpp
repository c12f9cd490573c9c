#include "ui/session/usable_controls.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <string_view>
#include <vector>

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

/// The keys of `value`, a part of `scene`, that something reads.
template <class T>
std::vector<std::string_view> usable_keys(const T &value, const Scene &scene, const Technique &left,
                                          const Technique &right) {
    std::vector<std::string_view> keys;
    for_each_field<T>([&](const auto &field) {
        if (is_usable(field, value, terms_of(scene, left, right))) {
            keys.push_back(field.key);
        }
    });
    return keys;
}

/// Is this property usable?
template <class T, class M>
bool usable(const T &value, M T::*member, const Scene &scene, const Technique &left, const Technique &right) {
    bool found = false;
    for_each_field<T>([&](const auto &field) {
        if constexpr (std::is_same_v<decltype(field.member), M T::*>) {
            found |= field.member == member && is_usable(field, value, terms_of(scene, left, right));
        }
    });
    return found;
}
template <class M> bool usable(const Light &light, M Light::*member) {
    return usable(light, member, scene_with({light}), phong, phong);
}

TEST(UsableControls, NoSpecularUnderLambertOnBothSides) {
    const Scene scene = scene_with({light_of(LightType::point)});
    const Material &material = scene.objects[0].material;
    EXPECT_FALSE(usable(scene.lights[0], &Light::specular, scene, lambert, lambert));
    EXPECT_FALSE(usable(material, &Material::specular, scene, lambert, lambert));
    EXPECT_FALSE(usable(material, &Material::shininess, scene, lambert, lambert));
    for (const auto &[left, right] : {std::pair{lambert, phong}, std::pair{blinn, lambert}, std::pair{phong, blinn}}) {
        EXPECT_TRUE(usable(scene.lights[0], &Light::specular, scene, left, right));
        EXPECT_TRUE(usable(material, &Material::specular, scene, left, right));
        EXPECT_TRUE(usable(material, &Material::shininess, scene, left, right));
    }
}

TEST(UsableControls, ATermAtZeroKeepsItsSlider) {
    Light dark = light_of(LightType::spot);
    dark.diffuse = dark.specular = dark.ambient = dark.exponent = 0;
    dark.color = {0, 0, 0};
    Scene scene = scene_with({dark});
    scene.objects[0].material.specular = {0, 0, 0};
    scene.objects[0].material.shininess = 0;
    EXPECT_EQ(usable_keys(dark, scene, phong, phong), usable_keys(light_of(LightType::spot), scene, phong, phong));
    const Material &material = scene.objects[0].material;
    EXPECT_TRUE(usable(material, &Material::specular, scene, phong, phong));
    EXPECT_TRUE(usable(material, &Material::shininess, scene, phong, phong));
    EXPECT_TRUE(usable(material, &Material::diffuse, scene, phong, phong));
}

TEST(UsableControls, DirectionalHasNoPlaceAndDoesNotFade) {
    const Light light = light_of(LightType::directional);
    EXPECT_TRUE(usable(light, &Light::direction));
    EXPECT_FALSE(usable(light, &Light::position));
    EXPECT_FALSE(usable(light, &Light::attenuation));
    EXPECT_FALSE(usable(light, &Light::attenuate_ambient));
    EXPECT_FALSE(usable(light, &Light::cutoff_degrees));
}

TEST(UsableControls, PointHasNoDirectionAndNoCone) {
    const Light light = light_of(LightType::point);
    EXPECT_TRUE(usable(light, &Light::position));
    EXPECT_TRUE(usable(light, &Light::attenuation));
    EXPECT_TRUE(usable(light, &Light::attenuate_ambient));
    EXPECT_FALSE(usable(light, &Light::direction));
    EXPECT_FALSE(usable(light, &Light::cutoff_degrees));
    EXPECT_FALSE(usable(light, &Light::inner_cutoff_degrees));
    EXPECT_FALSE(usable(light, &Light::exponent));
}

TEST(UsableControls, ASpotWithoutAConeIsAPointLight) {
    Light spot = light_of(LightType::spot);
    EXPECT_TRUE(usable(spot, &Light::cutoff_degrees));
    EXPECT_TRUE(usable(spot, &Light::inner_cutoff_degrees));
    EXPECT_TRUE(usable(spot, &Light::exponent));
    EXPECT_TRUE(usable(spot, &Light::direction));
    spot.cutoff_degrees = 180;
    EXPECT_TRUE(kind_of(spot.type).conical); // the switch for its cone stays
    EXPECT_FALSE(usable(spot, &Light::cutoff_degrees));
    EXPECT_FALSE(usable(spot, &Light::inner_cutoff_degrees));
    EXPECT_FALSE(usable(spot, &Light::exponent));
    EXPECT_FALSE(usable(spot, &Light::direction));
}

TEST(UsableControls, ALightThatIsOffHasNone) {
    Light off = light_of(LightType::spot);
    off.enabled = false;
    EXPECT_TRUE(usable_keys(off, scene_with({off}), phong, blinn).empty());
}

TEST(UsableControls, WithoutALightThatIsOnOnlyAmbientAndEmissionAreLeft) {
    Scene scene = scene_with({light_of(LightType::point)});
    scene.lights[0].enabled = false;
    const Material &material = scene.objects[0].material;
    for (const auto color : {&Material::diffuse, &Material::specular}) {
        EXPECT_FALSE(usable(material, color, scene, phong, blinn));
    }
    EXPECT_FALSE(usable(material, &Material::shininess, scene, phong, blinn));
    EXPECT_FALSE(usable(material, &Material::checker, scene, phong, blinn));
    EXPECT_FALSE(usable(material, &Material::texture_modulates_specular, scene, phong, blinn));
    EXPECT_FALSE(usable(scene, &Scene::blinn_exponent_scale, scene, phong, blinn));
}

TEST(UsableControls, BlinnScaleOnlyUnderBlinnPhong) {
    const Scene scene = scene_with({light_of(LightType::point)});
    EXPECT_FALSE(usable(scene, &Scene::blinn_exponent_scale, scene, phong, lambert));
    EXPECT_TRUE(usable(scene, &Scene::blinn_exponent_scale, scene, phong, blinn));
    EXPECT_TRUE(usable(scene, &Scene::blinn_exponent_scale, scene, blinn, lambert));
}

TEST(UsableControls, ModulatingTheHighlightNeedsASurfaceAndAHighlight) {
    Scene scene = scene_with({light_of(LightType::point)});
    Material &material = scene.objects[0].material;
    const auto modulates = [&](const Technique &technique) {
        return usable(material, &Material::texture_modulates_specular, scene, technique, technique);
    };
    EXPECT_FALSE(modulates(phong));
    material.texture = "checker.png";
    EXPECT_TRUE(modulates(phong));
    EXPECT_FALSE(modulates(lambert));
    material.texture.clear();
    material.checker = Checker{};
    EXPECT_TRUE(modulates(phong));
    EXPECT_TRUE(usable(material, &Material::checker, scene, phong, phong));
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
    EXPECT_FALSE(value_open(key_of("program"), static_cast<int>(Program::full), scene,
                            parse_technique("per-pixel/phong:attenuation=interpolated")));
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
    EXPECT_EQ(use(scene, pixel, "viewer", 1), ValueUse::no_effect) << "the winding says which side is seen";
    EXPECT_EQ(use(scene, pixel, "facing", 1), ValueUse::open);
    EXPECT_EQ(use(scene, pixel + ":facing=view", "viewer", 1), ValueUse::open) << "V says which side is seen";
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

#include "measure/work_precision/precision.h"

#include "measure/work_precision/run.h"
#include "reference/reference.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace sandbox {
namespace {

constexpr Size size{48, 36};

Scene ball_scene(LightType type) {
    Scene scene;
    Light light;
    light.type = type;
    light.position = {1, 2, 3};
    light.direction = {-0.3, -0.3, -1};
    light.diffuse = 0.2; // so that no highlight is beyond white
    light.specular = 0.8;
    scene.lights = {light};
    scene.objects = {{"ball", SphereShape{1, 16, 32}, {}, {}, false}};
    scene.objects[0].material.shininess = 128;
    return scene;
}

/// A lamp high above the ground: farther than 256 from all of it.
Scene far_lamp() {
    Scene scene = ball_scene(LightType::point);
    scene.camera.position = {0, 3, 3};
    scene.lights[0].position = {0, 300, 0};
    scene.objects[0].mesh = PlaneShape{{4, 4}, 1};
    return scene;
}

std::vector<ObjectResources> load(const Scene &scene) {
    return {{std::make_shared<const Mesh>(build_mesh(scene.objects[0].mesh)), nullptr}};
}

PrecisionFinding find(const Scene &scene, std::string_view technique) {
    return find_precision(scene, load(scene), parse_technique(technique), size);
}

reference::HighValues values_of(const std::vector<std::string> &names) {
    reference::HighValues high;
    for (std::size_t i = 0; i < reference::kept_count; ++i) {
        high[i] = std::ranges::find(names, reference::kept_names.at(i)) != names.end();
    }
    return high;
}

TEST(Precision, LevelsAreOfWhatADisplayShows) {
    Image a({1, 1}), b({1, 1});
    a.pixels[0] = {0.5F, 0, 2, 1};
    b.pixels[0] = {0.25F, 0, 9, 1};
    EXPECT_EQ(levels_between(a, b), 255 * 0.25) << "both of the third channel are white";
    b.pixels[0].y = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(levels_between(a, b), std::numeric_limits<double>::infinity());
}

TEST(Precision, DiffuseLightBearsHalf) {
    const PrecisionFinding found = find(ball_scene(LightType::directional), "per-pixel/lambert");
    EXPECT_GT(found.rounded, 0);
    EXPECT_LE(found.rounded, 1);
    EXPECT_TRUE(found.high.empty());
    EXPECT_EQ(found.left, found.rounded);
}

/// Each of the values that it names is needed, and together they are enough.
TEST(Precision, WhatStaysHighIsEnoughAndNoMore) {
    for (const auto &[scene, technique] : {std::pair{ball_scene(LightType::point), "per-pixel/phong"},
                                           {ball_scene(LightType::point), "per-pixel/blinn-phong"},
                                           {far_lamp(), "per-pixel/lambert"}}) {
        const PrecisionFinding found = find(scene, technique);
        EXPECT_GT(found.rounded, 1) << technique;
        ASSERT_FALSE(found.high.empty()) << technique;
        Technique medium = parse_technique(technique);
        const Image truth = reference_colors(scene, load(scene), medium, size);
        medium.precision = Precision::medium;
        const auto levels = [&](const reference::HighValues &high) {
            return levels_between(reference_colors(scene, load(scene), medium, size, high), truth);
        };
        const reference::HighValues high = values_of(found.high);
        EXPECT_EQ(high.count(), found.high.size());
        EXPECT_EQ(levels(high), found.left);
        EXPECT_LE(found.left, 1);
        for (std::size_t i = 0; i < reference::kept_count; ++i) {
            reference::HighValues fewer = high;
            fewer.reset(i);
            EXPECT_TRUE(!high.test(i) || levels(fewer) > 1) << technique << ": " << reference::kept_names.at(i);
        }
    }
}

TEST(Precision, ADistanceBeyond256NeedsItsDifferenceHigh) {
    const PrecisionFinding found = find(far_lamp(), "per-pixel/lambert");
    EXPECT_NE(std::ranges::find(found.high, "to_light"), found.high.end());
    EXPECT_GT(found.rounded, 50) << "the lamp is gone";
}

/// With everything high the twin is the reference: its equation is written a second time.
TEST(Precision, WithAllHighTheTwinIsTheReference) {
    for (const char *text :
         {"per-pixel/phong", "per-pixel/blinn-phong:power=stable", "interpolated-vectors/phong",
          "interpolated-vectors/blinn-phong", "hybrid/phong", "per-pixel/blinn-phong:gate=none",
          "per-pixel/blinn-phong:half_vector=constant", "per-pixel/phong:attenuation=interpolated"}) {
        Scene scene = ball_scene(LightType::spot);
        scene.lights.push_back(ball_scene(LightType::directional).lights[0]);
        scene.lights[0].direction = -scene.lights[0].position;
        scene.lights[0].cutoff_degrees = 30;
        scene.lights[0].inner_cutoff_degrees = 10;
        scene.lights[0].exponent = 3;
        scene.lights[0].attenuation = {0.2, 0.1, 0.05};
        Technique technique = parse_technique(text);
        const Image truth = reference_colors(scene, load(scene), technique, size);
        technique.precision = Precision::medium;
        const Image twin = reference_colors(scene, load(scene), technique, size, reference::HighValues().set());
        EXPECT_LE(levels_between(twin, truth), 255 * 1e-6) << text; // the series of log(1 - x), to 1e-7
    }
}

} // namespace
} // namespace sandbox

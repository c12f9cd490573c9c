#include "tools/stress_scenes.h"

#include "scene/scene_file.h"
#include "tools/shrink.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <set>
#include <string>

namespace sandbox {
namespace {

constexpr std::uint32_t seeds = 100;

template <class Visit> void for_each_stress_scene(const Visit &visit) {
    for (std::uint32_t family = 0; family < stress_families; ++family) {
        for (std::uint32_t seed = 0; seed < seeds; ++seed) {
            visit(stress_scene(family, seed));
        }
    }
}

TEST(StressScenes, AreWhatASceneFileMaySay) {
    for_each_stress_scene([](const StressScene &one) {
        EXPECT_EQ(parse_scene(scene_text(one.scene), one.scene.name, {}), one.scene) << one.scene.name;
        EXPECT_EQ(one.techniques.size(), stress_techniques);
    });
}

TEST(StressScenes, ReachEveryFrequencyModelAndProgram) {
    std::map<std::string, int> seen;
    for (std::uint32_t family = 0; family < stress_families; ++family) {
        for (const Technique &technique : stress_scene(family, 0).techniques) {
            ++seen[to_string(technique)];
        }
    }
    EXPECT_GE(seen.size(), 17U);
}

std::size_t zeros(const glm::dvec3 &v) {
    return static_cast<std::size_t>(v.x == 0) + static_cast<std::size_t>(v.y == 0) + static_cast<std::size_t>(v.z == 0);
}

double largest(const glm::dvec3 &v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

void note_object(std::map<std::string, int> &seen, const Object &object) {
    const glm::dvec3 &scale = object.transform.scale;
    ++seen["axes of scale 0: " + std::to_string(zeros(scale))];
    seen["mirrored"] += scale.x * scale.y * scale.z < 0 ? 1 : 0;
    seen["scale >= 1e13"] += largest(scale) >= 1e13 ? 1 : 0;
    seen["scale <= 1e-13"] += largest(scale) > 0 && largest(scale) <= 1e-13 ? 1 : 0;
    seen["placed >= 1e7"] += glm::length(object.transform.translate) >= 1e7 ? 1 : 0;
    seen["shininess 0"] += object.material.shininess == 0 ? 1 : 0;
    seen["shininess 1e7"] += object.material.shininess == 1e7 ? 1 : 0;
    if (const auto *obj = std::get_if<ObjShape>(&object.mesh)) {
        ++seen[obj->path];
    }
}

void note_view(std::map<std::string, int> &seen, const Scene &scene) {
    const Object &object = scene.objects[0];
    const auto *obj = std::get_if<ObjShape>(&object.mesh);
    const bool far_uvs = obj != nullptr && obj->path.find("far-and-near-uvs") != std::string::npos;
    const bool telescope = is_perspective(scene.camera) && scene.camera.fov_y_degrees < 0.02;
    ++seen[is_perspective(scene.camera) ? "perspective" : "orthographic"];
    seen["texture coordinates far from 0"] += far_uvs && !object.material.texture.empty() ? 1 : 0;
    seen["open and two-sided, through a telescope"] += far_uvs && object.two_sided && telescope ? 1 : 0;
}

void note_light(std::map<std::string, int> &seen, const Light &light) {
    seen["intensity 1e6"] += light.diffuse == 1e6 ? 1 : 0;
    seen["a color's channel 0"] += zeros(light.color) > 0 ? 1 : 0;
    const Attenuation &k = light.attenuation;
    seen["coefficient 1e9"] += std::max({k.constant, k.linear, k.quadratic}) == 1e9 ? 1 : 0;
    seen["coefficients <= 1e-6 alone"] += std::max({k.constant, k.linear, k.quadratic}) <= 1e-6 ? 1 : 0;
    if (light.type == LightType::spot) {
        for (const double cutoff : {0.0, 90.0, 180.0}) {
            seen["cutoff " + std::to_string(static_cast<int>(cutoff))] += light.cutoff_degrees == cutoff ? 1 : 0;
        }
        seen["spot exponent 1e5"] += light.exponent == 1e5 ? 1 : 0;
    }
}

TEST(StressScenes, ReachTheEndsOfEveryRange) {
    std::map<std::string, int> seen;
    std::set<std::size_t> counts;
    for_each_stress_scene([&](const StressScene &one) {
        note_object(seen, one.scene.objects[0]);
        note_view(seen, one.scene);
        for (const Light &light : one.scene.lights) {
            note_light(seen, light);
            const bool in_the_eye = light.type != LightType::directional && light.position == one.scene.camera.position;
            seen["a light in the eye"] += in_the_eye ? 1 : 0;
        }
        counts.insert(one.scene.lights.size());
    });
    for (const char *model : {"degenerate.obj", "huge-normals.obj", "opposite-normals.obj", "tiny-normals.obj",
                              "zero-normals.obj", "far-origin.obj", "axes of scale 0: 1", "axes of scale 0: 2"}) {
        seen.try_emplace(model, 0);
    }
    EXPECT_GE(seen["orthographic"], 100);
    EXPECT_GE(seen["open and two-sided, through a telescope"], 30);
    for (const auto &[what, count] : seen) {
        EXPECT_GE(count, 3) << what;
    }
    EXPECT_EQ(*counts.rbegin(), 64U);
    EXPECT_GE(counts.size(), 6U);
}

/// An artificial fault: a narrow spot on something turned.
TEST(Shrinking, KeepsOnlyWhatTheFaultNeeds) {
    const auto fails = [](const Scene &scene) {
        const bool spot = std::ranges::any_of(scene.lights, [](const Light &light) {
            return light.type == LightType::spot && light.exponent > 1000 && light.cutoff_degrees < 60;
        });
        return spot && !scene.objects.empty() && scene.objects[0].transform.rotate_degrees.y > 20;
    };
    std::uint32_t seed = 0;
    while (!fails(stress_scene(17, seed).scene)) {
        ++seed;
    }
    const Scene scene = stress_scene(17, seed).scene;
    ASSERT_EQ(scene.lights.size(), 5U);
    const Scene small = shrunk(scene, fails);
    EXPECT_TRUE(fails(small));
    EXPECT_EQ(parse_scene(scene_text(small), "small", {}), small);
    ASSERT_EQ(small.lights.size(), 1U);
    EXPECT_EQ(small.camera, Camera{});
    EXPECT_EQ(small.objects[0].material, Material{});
    EXPECT_EQ(small.lights[0].attenuation, Attenuation{});
    EXPECT_EQ(small.objects[0].transform.scale, glm::dvec3(1));
    EXPECT_LT(scene_text(small).size(), scene_text(scene).size() / 4) << scene_text(small);
}

TEST(Shrinking, LeavesWhatCannotBeSmaller) {
    const Scene scene = stress_scene(0, 0).scene;
    EXPECT_EQ(shrunk(scene, [&](const Scene &other) { return other == scene; }), scene);
}

} // namespace
} // namespace sandbox

#include "capture/sidecar.h"

#include "capture/picture_ranges.h"
#include "image/error.h"
#include "scene/scene_file.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <utility>

namespace sandbox {
namespace {

Scene ball() {
    Scene scene;
    scene.name = "ball";
    scene.camera.position = {0.1, 1.0 / 3, 6};
    scene.lights.push_back({});
    scene.objects.push_back({.name = "ball", .mesh = SphereShape{}, .transform = {}, .material = {}});
    return scene;
}

PictureOptions unusual() {
    PictureOptions options;
    options.layout = Layout::wipe;
    options.left = parse_technique("per-vertex/phong:normals=untransformed");
    options.right = parse_technique("per-pixel/blinn-phong:power=stable");
    options.textbook_left = true;
    options.size = {641, 359};
    options.display = Display::srgb;
    options.exposure = 0.1;
    options.gain = 3.7;
    options.divider = 0.3125;
    options.drawn_over = {.wireframe = true, .normals = false, .vertices = true, .lights = true};
    options.masks = true;
    options.labels = true;
    options.mesh_factors = {0.25, 2};
    options.view = "from-above";
    return options;
}

TEST(Sidecar, StandsBesideThePicture) { EXPECT_EQ(sidecar_path("out/a.png"), "out/a.png.json"); }

TEST(Sidecar, OptionsRoundTrip) {
    EXPECT_EQ(sidecar_options(sidecar_text(ball(), unusual(), {}), "a.json"), unusual());
    PictureOptions single;
    single.left = single.right = parse_technique("flat/lambert");
    EXPECT_EQ(sidecar_options(sidecar_text(ball(), single, {}), "a.json"), single);
    PictureOptions difference = unusual();
    difference.layout = Layout::difference;
    difference.divider = PictureOptions{}.divider;
    difference.difference_of = DifferenceOf::b_truth;
    EXPECT_EQ(sidecar_options(sidecar_text(ball(), difference, {}), "a.json"), difference);
    PictureOptions flip = unusual();
    flip.layout = Layout::single;
    flip.divider = PictureOptions{}.divider;
    flip.flip = FlipSide::b;
    EXPECT_EQ(sidecar_options(sidecar_text(ball(), flip, {}), "a.json"), flip);
}

TEST(Sidecar, TheSceneRoundTripsToTheLastBit) {
    const auto json = nlohmann::json::parse(sidecar_text(ball(), unusual(), {"soft", "3.3"}));
    EXPECT_EQ(parse_scene(json["scene"].dump(), "a.json", "/"), ball());
    EXPECT_EQ(json["renderer"], "soft");
    EXPECT_EQ(json["opengl"], "3.3");
    EXPECT_EQ(json["version"], SANDBOX_VERSION);
    EXPECT_EQ(json["techniques"].size(), 2U);
}

TEST(Sidecar, OnlyAWipeHasADivider) {
    PictureOptions options = unusual();
    EXPECT_NE(sidecar_text(ball(), options, {}).find("divider"), std::string::npos);
    options.layout = Layout::side_by_side;
    EXPECT_EQ(sidecar_text(ball(), options, {}).find("divider"), std::string::npos);
}

TEST(Sidecar, OtherFilesAreNone) {
    EXPECT_FALSE(sidecar_options(scene_text(ball()), "scene.json"));
    EXPECT_FALSE(sidecar_options("v 0 0 0", "mesh.obj"));
    EXPECT_FALSE(sidecar_options("[1, 2]", "list.json"));
}

TEST(Sidecar, AWrongValueIsRefusedByItsKey) {
    const std::string good = sidecar_text(ball(), unusual(), {});
    for (const auto &[key, value] :
         std::vector<std::pair<std::string, nlohmann::json>>{{"layout", "stacked"},
                                                             {"layout", 3},
                                                             {"techniques", nlohmann::json::array()},
                                                             {"techniques", {"flat"}},
                                                             {"size", "640x480"},
                                                             {"size", {1}},
                                                             {"size", {1e300, 5}},
                                                             {"size", {-5, 5}},
                                                             {"size", {99999, 99999}},
                                                             {"exposure", -1},
                                                             {"exposure", 1e9},
                                                             {"gain", 0},
                                                             {"display", "gamma"},
                                                             {"exposure", "bright"},
                                                             {"divider", 1.5},
                                                             {"divider", "left"},
                                                             {"wireframe", 1},
                                                             {"normals", "yes"},
                                                             {"lights", 0},
                                                             {"flip", "a"},
                                                             {"difference_of", "a-truth"},
                                                             {"labels", "yes"}}) {
        auto json = nlohmann::json::parse(good);
        json[key] = value;
        try {
            sidecar_options(json.dump(), "a.png.json");
            ADD_FAILURE() << key << " = " << value;
        } catch (const InputError &error) {
            EXPECT_EQ(std::string(error.what()).rfind("a.png.json: " + key, 0), 0U) << error.what();
        }
    }
}

TEST(Sidecar, HoldsTheEndsOfWhatTheWindowOffers) {
    for (const auto &[exposure, gain] : {std::pair(0.0, gain_range.low), std::pair(exposure_range.high, 1e9)}) {
        PictureOptions options;
        options.exposure = exposure;
        options.gain = gain;
        EXPECT_EQ(sidecar_options(sidecar_text(ball(), options, {}), "a.json"), options) << exposure;
    }
}

} // namespace
} // namespace sandbox

#include "capture/grid.h"
#include "capture/picture_ranges.h"
#include "capture/sidecar.h"
#include "image/error.h"
#include "image/write_files.h"
#include "scene/motion.h"
#include "scene/orbit.h"
#include "scene/scene_file.h"
#include "scene/scene_read.h"
#include "scene/scene_setting.h"
#include "tools/random_scene.h"
#include "tools/temporary_folder.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <random>

/// Whatever this program writes, it reads back.
namespace sandbox {
namespace {

namespace fs = std::filesystem;

class Dice {
  public:
    explicit Dice(unsigned seed) : random_(seed) {}
    double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
    int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
    bool coin() { return whole(0, 1) == 1; }
    /// An end of the range, or what lies within.
    double within(const Range &range) {
        const int end = whole(0, 2);
        return end == 0 ? range.low : end == 1 ? range.high : number(range.low, range.high);
    }
    glm::dvec3 far_place() {
        const double reach = std::pow(10, number(-2, 10));
        return {number(-reach, reach), number(-reach, reach), number(-reach, reach)};
    }

  private:
    std::mt19937 random_;
};

PictureOptions random_options(unsigned seed) {
    Dice dice(seed);
    PictureOptions options;
    options.layout = static_cast<Layout>(dice.whole(0, 4));
    options.flip = options.layout == Layout::single ? static_cast<FlipSide>(dice.whole(0, 2)) : FlipSide::none;
    options.left = random_technique(seed);
    options.right =
        options.layout == Layout::single && options.flip == FlipSide::none ? options.left : random_technique(seed + 1);
    options.mesh_factors = {dice.number(least_mesh_factor, most_mesh_factor), most_mesh_factor};
    options.textbook_left = dice.coin();
    options.size = {dice.whole(1, 8192), dice.whole(1, 8192)};
    options.display = dice.coin() ? Display::srgb : Display::linear;
    options.exposure = dice.within(exposure_range);
    options.gain = dice.within(gain_range);
    options.samples = dice.whole(1, 256);
    options.labels = dice.coin();
    options.masks = dice.coin();
    options.language = dice.coin() ? "zh" : "en";
    options.divider = options.layout == Layout::wipe ? dice.within({.low = 0, .high = 1}) : options.divider;
    options.difference_of =
        options.layout == Layout::difference ? static_cast<DifferenceOf>(dice.whole(0, 2)) : options.difference_of;
    for (const OverlayKind &kind : overlay_kinds) {
        options.drawn_over.*kind.on = dice.coin();
    }
    if (dice.coin()) {
        options.marks.pixel = {dice.number(0, 1), 1};
        options.marks.vectors = dice.coin();
        options.marks.profile = dice.within({.low = 0, .high = 1});
        options.marks.ring = {0, dice.number(0, 1), 1};
    }
    options.view = dice.coin() ? "from \"above\"" : "";
    return options;
}

TEST(ReadsBack, AnySceneUnderAnyOptions) {
    for (unsigned seed = 0; seed < 400; ++seed) {
        const Scene scene = random_scene(seed);
        const PictureOptions options = random_options(seed);
        const std::string text = sidecar_text(scene, options, {});
        EXPECT_EQ(parse_scene(text, "a.png.json", {}), scene) << seed;
        EXPECT_EQ(sidecar_options(text, "a.png.json"), options) << seed << text;
    }
}

void expect_read_back(const Scene &scene, const std::string &what) {
    const std::string text = scene_text(scene);
    try {
        EXPECT_EQ(parse_scene(text, "a.json", {}), scene) << what;
    } catch (const InputError &error) {
        ADD_FAILURE() << what << ": " << error.what();
    }
}

TEST(ReadsBack, CamerasThatAreMovedByHand) {
    for (unsigned seed = 0; seed < 60; ++seed) {
        Dice dice(seed);
        Scene scene;
        Camera &camera = scene.camera;
        camera.target = dice.far_place();
        camera.position = dice.far_place();
        camera.near_plane = std::pow(10, dice.number(-6, 2));
        camera.far_plane = camera.near_plane * std::pow(10, dice.number(1, 12));
        for (int step = 0; step < 40; ++step) {
            switch (dice.whole(0, 4)) {
            case 0:
                camera = orbited(camera, dice.number(-500, 500), dice.number(-200, 200));
                break;
            case 1:
                camera = dollied(camera, std::pow(10, dice.number(-3, 3)));
                break;
            case 2:
                camera = panned(camera, dice.number(-9, 9), dice.number(-9, 9));
                break;
            case 3:
                camera = at_pose(camera,
                                 {dice.number(-180, 180), dice.number(-most_elevation_degrees, most_elevation_degrees),
                                  std::pow(10, dice.number(-6, 11))});
                break;
            default:
                camera = with_projection(camera,
                                         is_perspective(camera) ? Projection::orthographic : Projection::perspective);
            }
            expect_read_back(scene, fmt::format("seed {} step {}", seed, step));
        }
    }
}

TEST(ReadsBack, WhatMovesOrIsRefused) {
    int moved_scenes = 0;
    for (unsigned seed = 0; seed < 60; ++seed) {
        Dice dice(seed);
        Scene scene = random_scene(seed);
        scene.camera.target = dice.far_place();
        scene.camera.position = scene.camera.target + glm::dvec3(1, 2, 3);
        if (scene.lights.empty()) {
            scene.lights.emplace_back();
        }
        for (const Mover mover : {Mover::camera, Mover::light}) {
            for (int moment = 0; moment < 24; ++moment) {
                try {
                    const Scene now = moved(scene, {.mover = mover, .seconds = 0.8}, moment);
                    expect_read_back(now, fmt::format("seed {} moment {}", seed, moment));
                    ++moved_scenes;
                } catch (const InputError &error) {
                    EXPECT_NE(std::string(error.what()).find("expected coordinates within"), std::string::npos)
                        << error.what();
                }
            }
        }
    }
    EXPECT_GT(moved_scenes, 1000) << "of 2880: most orbits stay within the world";
}

TEST(ReadsBack, EveryNumberAtTheEndsOfItsRange) {
    for (unsigned seed = 0; seed < 6; ++seed) {
        const Scene scene = random_scene(seed);
        for (const SceneNumber &number : numbers_of(scene)) {
            for (const double value : {number.range.low, number.range.high, number.range.or_exactly}) {
                if (std::isfinite(value)) {
                    try {
                        expect_read_back(with_setting(scene, fmt::format("{}={}", number.path, value)), number.path);
                    } catch (const InputError &) { // a low that is itself refused, two rows of a mesh, ...
                    }
                }
            }
        }
    }
}

TEST(ReadsBack, ExposureOf0AndCamerasWithin1e10) {
    Scene scene;
    scene.camera.position = {1e10, -1e10, 1e10};
    scene.camera.target = {-1e10, 1e10, 0};
    PictureOptions options;
    options.exposure = 0;
    const std::string text = sidecar_text(scene, options, {});
    EXPECT_EQ(parse_scene(text, "a", {}), scene);
    EXPECT_EQ(sidecar_options(text, "a"), options);
}

/// A folder of maps/a.png, models/b.obj and out/ for captures.
void make_project(const fs::path &folder) {
    fs::create_directories(folder / "maps");
    fs::create_directories(folder / "models");
    fs::create_directories(folder / "out");
    for (const char *name : {"maps/a.png", "models/b.obj", "out/c.png"}) {
        write_file(folder / name, "");
    }
}
Scene scene_of_project(const fs::path &folder) {
    Scene scene;
    Object textured;
    textured.material.texture = (folder / "maps/a.png").string();
    Object model;
    model.mesh = ObjShape{(folder / "models/b.obj").string()};
    model.material.texture = (folder / "out/c.png").string();
    Object built_in;
    built_in.material.texture = "checker.png";
    scene.objects = {textured, model, built_in};
    return scene;
}

TEST(ReadsBack, PathsInAFolderThatMoves) {
    const TemporaryFolder folder;
    const fs::path before = fs::canonical(folder.path()) / "before", after = fs::canonical(folder.path()) / "after";
    make_project(before);
    const std::string text = sidecar_text(scene_of_project(before), {}, {}, before / "out");
    EXPECT_NE(text.find(R"("../maps/a.png")"), std::string::npos) << text;
    EXPECT_NE(text.find(R"("../models/b.obj")"), std::string::npos) << text;
    EXPECT_NE(text.find(R"("./c.png")"), std::string::npos) << text;
    EXPECT_EQ(parse_scene(text, "a", before / "out"), scene_of_project(before));
    fs::rename(before, after);
    EXPECT_EQ(parse_scene(text, "a", after / "out"), scene_of_project(after));
}

TEST(ReadsBack, PathsInAFolderThatIsALink) {
    const TemporaryFolder folder;
    const fs::path real = fs::canonical(folder.path()) / "real", link = fs::canonical(folder.path()) / "link";
    make_project(real);
    fs::create_directory_symlink(real / "out", link);
    const std::string text = sidecar_text(scene_of_project(real), {}, {}, link);
    Scene by_link = scene_of_project(real);
    by_link.objects[1].material.texture = (link / "c.png").string();
    EXPECT_EQ(parse_scene(text, "a", link), by_link);
    EXPECT_EQ(parse_scene(text, "a", real / "out"), scene_of_project(real));
}

TEST(PathFrom, IsRelativeUnlessTheRootAloneIsShared) {
    EXPECT_EQ(path_from("/a/b/c.png", "/a/b"), "./c.png");
    EXPECT_EQ(path_from("/a/b/c.png", "/a"), "b/c.png");
    EXPECT_EQ(path_from("/a/b/c.png", "/a/d/e"), "../../b/c.png");
    EXPECT_EQ(path_from("/a/b/c.png", "/d/e"), "/a/b/c.png");
    EXPECT_EQ(path_from("/a/b/c.png", "/"), "a/b/c.png");
    EXPECT_EQ(path_from("checker.png", "/a"), "checker.png");
    EXPECT_EQ(path_from("/a/b/c.png", ""), "/a/b/c.png");
    EXPECT_EQ(path_from("", "/a"), "");
}

TEST(ReadsBack, OwnShadingAndTheFilesOfAGridInAFolderThatMoves) {
    const TemporaryFolder folder;
    const fs::path before = fs::canonical(folder.path()) / "before", after = fs::canonical(folder.path()) / "after";
    make_project(before);
    const std::string own = "vec3 lighting(vec3 P, vec3 N, vec3 eye) { return N; }\n";
    write_file(before / "mine.glsl", own);
    const auto technique_in = [&](const fs::path &in) {
        return parse_technique_with(OwnShader((in / "mine.glsl").string(), own), "per-pixel/own");
    };
    PictureOptions options;
    options.left = options.right = technique_in(before);
    const Grid grid{{technique_in(before)},
                    {"objects[0].material.texture", {"maps/a.png", "\"out/c.png\"", "checker.png"}},
                    before};
    const fs::path out = before / "out";
    const std::string text = grid_text(sidecar_text(scene_of_project(before), options, {}, out), grid, out);
    EXPECT_EQ(sidecar_options(text, "a", out), options);
    fs::rename(before, after);
    EXPECT_EQ(sidecar_options(text, "a", after / "out")->left, technique_in(after));
    const auto read = grid_of(text, "a", after / "out");
    ASSERT_TRUE(read);
    EXPECT_EQ(read->techniques.front(), technique_in(after));
    ASSERT_EQ(read->sweep.values.size(), 3U);
    EXPECT_EQ(file_of_value(*read, read->sweep.values[0]), (after / "maps/a.png").string());
    EXPECT_EQ(file_of_value(*read, read->sweep.values[1]), (after / "out/c.png").string());
    EXPECT_EQ(file_of_value(*read, read->sweep.values[2]), "checker.png");
}

} // namespace
} // namespace sandbox

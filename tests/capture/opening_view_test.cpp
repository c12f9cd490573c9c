#include "capture/opening_view.h"

#include "capture/sidecar.h"
#include "scene/scene_file.h"
#include "scene/scene_setting.h"
#include "tools/error_of.h"

#include <gtest/gtest.h>

namespace sandbox {
namespace {

Scene scene_that_opens(const Opening &opening) {
    Scene scene;
    scene.compare = opening;
    return scene;
}

TEST(OpeningView, IsWhatTheKeyCompareSays) {
    const Scene scene = parse_scene(
        R"({"compare": {"left": "flat/phong:gate=none", "right": "per-pixel/phong", "layout": "wipe"}})", "a.json", {});
    const OpeningView view = opening_view(scene, "a.json");
    EXPECT_EQ(view.left, parse_technique("flat/phong:gate=none"));
    EXPECT_EQ(view.right, parse_technique("per-pixel/phong"));
    EXPECT_EQ(view.layout, Layout::wipe);
}

TEST(OpeningView, EachPartMayBeAbsent) {
    const OpeningView none = opening_view(Scene{}, "a.json");
    EXPECT_FALSE(none.left || none.right || none.layout);
    const OpeningView one = opening_view(scene_that_opens({"", "per-pixel/phong", ""}), "a.json");
    EXPECT_TRUE(!one.left && one.right && !one.layout);
}

TEST(OpeningView, ErrorsNameFileAndKey) {
    const auto error = [](const Opening &opening) {
        return error_of([&] { opening_view(scene_that_opens(opening), "a.json"); });
    };
    EXPECT_TRUE(error({"per-vertx/phong", "", ""}).starts_with("a.json: compare.left: "));
    EXPECT_TRUE(error({"", "per-pixel/fong", ""}).starts_with("a.json: compare.right: "));
    EXPECT_EQ(error({"", "", "beside"}),
              "a.json: compare.layout: expected side-by-side, wipe, difference or three-up, got 'beside'");
}

TEST(OpeningView, SettingsReachItAndSidecarsHoldIt) {
    const Scene scene = with_setting(Scene{}, "compare.left=flat/lambert");
    EXPECT_EQ(scene.compare, (Opening{"flat/lambert", "", ""}));
    EXPECT_EQ(parse_scene(sidecar_text(scene, {}, {}), "a.png.json", {}), scene);
}

/// Whatever a built-in scene opens with can be drawn, and A and B are not the same technique.
TEST(OpeningView, EveryBuiltInSceneHasOne) {
    for (const std::string &name : builtin_scenes(Assets("assets"))) {
        const OpeningView view = opening_view(open_scene(name, Assets("assets")), name);
        ASSERT_TRUE(view.left && view.right && view.layout) << name;
        EXPECT_NE(view.left, view.right) << name;
    }
}

} // namespace
} // namespace sandbox

#include "commands/script_gl.h"

#include <cstdlib>

/// Techniques that say something of themselves.
namespace sandbox {
namespace {

TEST_F(ScriptGl, AutoHasATolerance) {
    EXPECT_PLAYED(play(R"(
click Technique/B/auto
expect B/name "auto / phong"
wait
key Tab
shot first.png
key Q
shot striped.png
key Q
shot plain.png
key Tab
drag Technique/B/tolerance 0.1
expect Technique/B/tolerance 0.1
key Tab
key Q
shot looser.png
key Tab
texts
click Technique/B/per-pixel
expect B/name per-pixel
key Ctrl+Z
key Ctrl+Z
expect Technique/B/tolerance 0.00392
)",
                       {"vase", "--left", "per-vertex/phong", "--right", "per-pixel/phong"}));
    expect_other("first.png", "striped.png");
    expect_same("first.png", "plain.png");
    expect_other("striped.png", "looser.png");
}

/// OpenGL ES has a precision to ask for, desktop OpenGL has none.
TEST_F(ScriptGl, HalfPrecisionStandsBesideTheDevicesOwn) {
    if (std::getenv("SANDBOX_TESTED_PROFILE") != nullptr) {
        GTEST_SKIP() << "chooses the profile itself";
    }
    const auto expect = [&](const std::string &profile, const std::string &text) {
        EXPECT_PLAYED(play("wait\nexpect B/device \"" + text + "\"\ntexts\n",
                           {"vase", "--right", "per-pixel/phong:precision=medium", "--profile", profile}));
    };
    expect("core", "no mediump");
    expect("es", "mediump");
}

} // namespace
} // namespace sandbox

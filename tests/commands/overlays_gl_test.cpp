#include "commands/script_gl.h"

#include <fmt/format.h>
#include <string>

namespace sandbox {
namespace {

TEST_F(ScriptGl, OverlaysAreSwitchedCapturedAndRestored) {
    EXPECT_PLAYED(play(R"(
key Tab
shot plain.png
key N
shot normals.png
key V
shot vertices.png
key I
shot lights.png
key F12
wait
key N
key V
key I
shot again.png
)"));
    expect_other("plain.png", "normals.png");
    expect_other("normals.png", "vertices.png");
    expect_other("vertices.png", "lights.png");
    expect_same("plain.png", "again.png");
    const std::string sidecar = "three-point-lights-001.png.json";
    EXPECT_PLAYED(run_sandbox({"capture", sidecar, "--out", "again.png"}, "cd " + folder.path().string() + " && env"));
    expect_same("three-point-lights-001.png", "again.png");
    EXPECT_PLAYED(play("key Tab\nshot restored.png\n", {sidecar}));
    expect_same("lights.png", "restored.png");
}

TEST_F(ScriptGl, ADraggedLightMovesAndTheCameraStays) {
    EXPECT_PLAYED(play(R"(
click "Lights/lights in the pictures"
hover Status
shot before.png
drag "B/light 1" 40 -20
shot dragged.png
key Ctrl+Z
hover Status
shot undone.png
key Ctrl+Shift+Z
key 4
drag "View/light 1" -40 20
key 1
hover Status
shot back.png
)"));
    expect_other("before.png", "dragged.png");
    expect_same("before.png", "undone.png");
}

TEST_F(ScriptGl, ASpotsTipAndAnArrowsTailTurnTheirLights) {
    for (const auto &[scene, handle] :
         {std::pair("spot-light", "A/light 1 tip"), std::pair("directional-light", "A/light 1")}) {
        EXPECT_PLAYED(play("key I\nwheel A/picture -5\nexpect A/error max\nexpect \"" + std::string(handle) +
                               "\" light\ndrag \"" + handle +
                               "\" 30 10\nshot turned.png\nkey Ctrl+Z\nhover Status\nshot undone.png\n",
                           {scene}));
        expect_other("turned.png", "undone.png");
    }
}

TEST_F(ScriptGl, AProfileReadsThePictureWithoutTheLinesOverIt) {
    std::string along; // the line of the profile, across the floor's edges
    for (int x = 120; x < 300; x += 9) {
        along += fmt::format("hover A/picture {} 100\nlist Profile/A\n", x);
    }
    const ProcessResult plain = play("key L\n" + along), lines = play("key W\nkey V\nkey L\n" + along);
    EXPECT_EQ(plain.exit_code, 0) << plain.err;
    EXPECT_EQ(plain.out, lines.out);
    EXPECT_NE(plain.out.find("Profile/A"), std::string::npos);
}

} // namespace
} // namespace sandbox

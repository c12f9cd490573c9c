#include "commands/script_gl.h"

/// Motions in the window, worked by scripts, and their sequences.
namespace sandbox {
namespace {

using MotionGl = ScriptGl;

TEST_F(MotionGl, AMotionPlaysStepsStopsAndIsKept) {
    EXPECT_PLAYED(play(R"(
click Motion
type Motion/seconds 1
expect Motion/moment "the scene itself"
shot first.png
key A
play 5
expect Motion/moment "moment 5 of 30"
key A
play 5
expect Motion/moment "moment 5 of 30"
hover Status
shot five.png
key .
key ,
hover Status
shot five-again.png
click Motion/Stop
hover Status
shot stopped.png
key .
click Motion/Keep
expect Motion/moment "the scene itself"
key Ctrl+Z
hover Status
shot undone.png
)"));
    expect_other("first.png", "five.png");
    expect_same("five.png", "five-again.png");
    expect_same("stopped.png", "undone.png");
}

TEST_F(MotionGl, ARoundIsCapturedAndItsSidecarMakesItAgain) {
    EXPECT_PLAYED(play(R"(
click Motion
type Motion/seconds 0.1
click "Motion/Capture the sequence"
expect Status "Captured to"
)",
                       {"point-light"}));
    const std::string frame = "point-light-motion-001/frame_000";
    EXPECT_PLAYED(run_sandbox({"capture", "point-light-motion-001/frame_%04d.png.json", "--out", "again_%04d.png"},
                              "cd " + folder.path().string() + " && env"));
    for (const char *number : {"0", "1", "2"}) {
        expect_same(frame + number + ".png", std::string("again_000") + number + ".png");
    }
    expect_other("again_0000.png", "again_0001.png");
    EXPECT_TRUE(folder.read("point-light-motion-001/frame_%04d.png.json") == folder.read("again_%04d.png.json"));
}

} // namespace
} // namespace sandbox

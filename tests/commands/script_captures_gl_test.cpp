#include "commands/script_gl.h"
#include "image/png.h"

#include <filesystem>

/// What the window writes and takes: captures that wait, masks, sweeps, dropped textures; and the profile's terms.
namespace sandbox {
namespace {

using CapturesGl = ScriptGl;

/// F12 again and again without waiting: each shows what was shown then, and none is lost.
TEST_F(CapturesGl, CapturesWaitForEachOther) {
    EXPECT_PLAYED(play("key 5\nwait\nkey F12\nkey F12\nclick Technique/A/flat\nkey F12\nexpect Status Captured\n"));
    expect_same("three-point-lights-001.png", "three-point-lights-002.png");
    expect_other("three-point-lights-002.png", "three-point-lights-003.png");
}

/// One is written, eight wait; a tenth is refused and said. The window that closes writes those that wait.
TEST_F(CapturesGl, AtMostEightWaitAndAClosingWindowWritesThem) {
    std::string keys;
    for (int i = 0; i < 12; ++i) {
        keys += "key F12\n";
    }
    EXPECT_PLAYED(play("size 1280x720\nkey 5\nwait\n" + keys));
    EXPECT_TRUE(std::filesystem::exists(folder.file("three-point-lights-009.png")));
    EXPECT_FALSE(std::filesystem::exists(folder.file("three-point-lights-013.png")));
}

TEST_F(CapturesGl, MasksAreCapturedAsShownAndComeBack) {
    EXPECT_PLAYED(play("key K\nwait\nkey F12\nkey K\nkey F12\nwait\n"));
    expect_other("three-point-lights-001.png", "three-point-lights-002.png");
    const std::string sidecar = folder.file("three-point-lights-001.png.json");
    EXPECT_NE(folder.read("three-point-lights-001.png.json").find("\"masks\": true"), std::string::npos);
    EXPECT_PLAYED(run_sandbox({"capture", sidecar, "--out", folder.file("again.png")}));
    expect_same("again.png", "three-point-lights-001.png");
    EXPECT_PLAYED(run_sandbox(
        {"capture", folder.file("three-point-lights-002.png.json"), "--masks", "--out", folder.file("asked.png")}));
    expect_same("asked.png", "three-point-lights-001.png");
    EXPECT_PLAYED(play("key F12\nwait\n", {"three-point-lights-001.png.json"}));
    expect_same("three-point-lights-001.png-001.png", "three-point-lights-001.png");
    const Arguments capture{"capture", "box-1-colour", "--masks", "--out"};
    for (const Arguments &refused :
         {Arguments{"no.png", "--layout", "difference", "--left", "flat/phong", "--right", "per-pixel/phong"},
          Arguments{"no.png", "--samples", "4"}, Arguments{"no.pfm"}}) {
        Arguments all = capture;
        all.insert(all.end(), refused.begin(), refused.end());
        const ProcessResult result = run_sandbox(all);
        EXPECT_EQ(result.exit_code, 2);
        EXPECT_NE(result.err.find("masks"), std::string::npos) << result.err;
    }
}

/// What the Motion tab writes is what the command makes of its sidecar.
TEST_F(CapturesGl, ASweepIsCapturedAndItsSidecarMakesItAgain) {
    EXPECT_PLAYED(play(R"(
click Motion
click Motion/what
click "Motion/what/objects[0].material.shininess"
type Motion/from 8
type Motion/to 64
type Motion/values 3
wait
click "Motion/Capture a sweep of"
expect Status "Captured to"
)"));
    const std::string sidecar = folder.read("three-point-lights-sweep-001.png.json");
    EXPECT_NE(sidecar.find("\"sweep\": \"objects[0].material.shininess=8,36,64\""), std::string::npos) << sidecar;
    EXPECT_PLAYED(run_sandbox(
        {"capture", folder.file("three-point-lights-sweep-001.png.json"), "--out", folder.file("again.png")}));
    expect_same("three-point-lights-sweep-001.png", "again.png");
    EXPECT_EQ(sidecar, folder.read("again.png.json"));
}

TEST_F(CapturesGl, ACancelledSweepWritesNothing) {
    EXPECT_PLAYED(play(R"(
key K
click Motion
click Motion/what
click "Motion/what/lights[0].diffuse"
type Motion/values 16
click "Motion/Capture a sweep of"
click Motion/Cancel
expect Status "Not captured"
)"));
    EXPECT_FALSE(std::filesystem::exists(folder.file("three-point-lights-sweep-001.png")));
}

/// An image that is dropped is the texture of the object that the Material panel shows; undo takes it off again, and
/// what cannot be read changes nothing.
TEST_F(CapturesGl, ADroppedImageIsATexture) {
    ByteImage image{{2, 2}, {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255}};
    folder.write("stripes.png", encode_png(image));
    folder.write("bad.JPG", "no picture");
    EXPECT_PLAYED(play(R"(
drop bad.JPG
expect Status "No texture: "
expect Status bad.JPG
drop gone.png
expect Status "No texture: "
drop stripes.png
expect Status "stripes.png is the texture of"
key F12
wait
)"));
    const std::string sidecar = folder.read("three-point-lights-001.png.json");
    EXPECT_NE(sidecar.find("\"./stripes.png\""), std::string::npos);
    EXPECT_PLAYED(
        run_sandbox({"capture", folder.file("three-point-lights-001.png.json"), "--out", folder.file("again.png")}));
    expect_same("again.png", "three-point-lights-001.png");
    EXPECT_PLAYED(play("key Tab\nshot first.png\ndrop bad.JPG\nshot bad.png\ndrop stripes.png\nshot textured.png\n"
                       "key Ctrl+Z\nshot back.png\n"));
    expect_same("first.png", "bad.png");
    expect_other("first.png", "textured.png");
    expect_same("first.png", "back.png");
}

/// The choice has the terms that A or B has.
TEST_F(CapturesGl, AProfileShowsOneTerm) {
    EXPECT_PLAYED(play(R"(
key L
hover A/picture 150 60
expect Profile/what "luminance of row"
click Profile/specular
hover A/picture 150 60
expect Profile/what "specular in double"
expect Profile/A "A  0."
expect Profile/truth "truth  0."
hover Status
shot specular.png
click Profile/diffuse
hover Status
shot diffuse.png
click Profile/ambient
hover Status
shot ambient.png
drag A/picture 0 0
longest
)"));
    expect_other("specular.png", "diffuse.png");
    expect_other("diffuse.png", "ambient.png");
    EXPECT_PLAYED(play("key L\nexpect Profile/specular specular\nclick Technique/A/lambert\nclick Technique/B/lambert\n"
                       "click Profile/diffuse\nexpect Profile/what \"diffuse in double\"\n"));
    EXPECT_EQ(play("key L\nclick Technique/A/lambert\nclick Technique/B/lambert\nclick Profile/specular\n").exit_code,
              2)
        << "there is no such term";
}

} // namespace
} // namespace sandbox

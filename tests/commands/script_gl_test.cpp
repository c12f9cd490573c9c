#include "commands/script_gl.h"
#include "image/png.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <iterator>
#include <sstream>
#include <thread>

namespace sandbox {
namespace {

TEST_F(ScriptGl, UndoBringsBackWhatClickKeyAndDragChanged) {
    EXPECT_PLAYED(play(R"(
key Tab
shot first.png
key Tab
click Technique/A/flat
expect A/name flat
key Tab
shot flat.png
key Tab
key Ctrl+Z
expect A/name per-vertex
key Ctrl+Shift+Z
expect A/name flat
key Ctrl+Z
key M
expect A/name lambert
key Ctrl+Z
expect A/name "per-vertex / blinn-phong"
drag Lights/1/diffuse 0
expect Lights/1/diffuse 0.000
key Ctrl+Z
expect Lights/1/diffuse 0.8
type Lights/1/diffuse 0.25
expect Lights/1/diffuse 0.250
right-click Lights/1/diffuse
expect Lights/1/diffuse 0.8
key Tab
shot back.png
)"));
    expect_other("first.png", "flat.png");
    expect_same("first.png", "back.png");
}

TEST_F(ScriptGl, TheCameraComesBack) {
    EXPECT_PLAYED(play(R"(
hover A/picture
shot first.png
drag A/picture 80 30
hover A/picture
shot turned.png
key R
shot reset.png
wheel A/picture 2
shot nearer.png
double-click A/picture
shot back.png
)"));
    expect_other("first.png", "turned.png");
    expect_same("first.png", "reset.png");
    expect_other("first.png", "nearer.png");
    expect_same("first.png", "back.png");
}

TEST_F(ScriptGl, ACoarseMeshStandsBesideAFineOne) {
    EXPECT_PLAYED(play(R"(
click Mesh
expect Mesh/triangles "960 triangles"
click "Mesh/in A alone/1/4"
click "Mesh/in B alone/2"
expect A/name "mesh x 1/4"
expect B/name "mesh x 2"
expect View/differ "frequency (where the equation runs), mesh"
expect Mesh/triangles "A: 48 triangles, B: 3968"
click "Mesh/in A and B/2"
expect Mesh/rings 32
expect Mesh/triangles "A: 224 triangles, B: 16128"
key Ctrl+Z
expect Mesh/rings 16
key F12
)",
                       {"three-point-lights"}));
    const std::string sidecar = "three-point-lights-001.png.json";
    EXPECT_PLAYED(run_sandbox({"capture", sidecar, "--out", "again.png"}, "cd " + folder.path().string() + " && env"));
    expect_same("three-point-lights-001.png", "again.png");
    EXPECT_PLAYED(play("expect A/name \"mesh x 1/4\"\n", {sidecar}));
}

TEST_F(ScriptGl, EveryLayoutShowsSomethingElse) {
    EXPECT_PLAYED(play(R"(
hover Status
shot 1.png
key 2
shot 2.png
drag View/divider 100 0
hover Status
shot 2b.png
key 3
shot 3.png
hold Space
shot 3b.png
release Space
shot 3c.png
key 4
shot 4.png
key 1
shot 1b.png
)"));
    expect_other("1.png", "2.png");
    expect_other("2.png", "2b.png");
    expect_other("3.png", "3b.png");
    expect_same("3.png", "3c.png");
    expect_other("3.png", "4.png");
    expect_same("1.png", "1b.png");
}

TEST_F(ScriptGl, TheTruthStandsUnderEachView) {
    EXPECT_PLAYED(play(R"(
expect View/differ "A and B differ in: frequency"
expect View/description "highlights"
expect A/error "max 0."
expect B/error "max "
key 5
expect Truth/name "truth  Blinn-Phong, per"
key 4
click Difference/fit
click "Difference/B − truth"
expect Difference/largest "edges included"
key X
key X
click Technique/A/per-pixel
click Technique/A/blinn-phong
expect View/differ "same technique"
click "Difference/A − B"
expect Difference/largest "no pixel differs"
)"));
    EXPECT_PLAYED(
        play("expect View/differ \"A and B differ in: frequency\"\nexpect A/name \"per-vertex / blinn-phong\"\n"
             "expect View/description highlights\n",
             {})); // the opening picture
    // A box, small: on a busy machine, too, enough draws fit into the second that timing may take.
    const ProcessResult timed =
        run_sandbox({"view", "box-1-colour", "--size", "640x480", "--script", folder.file("times.txt")},
                    "echo 'expect A/time ms' > " + folder.file("times.txt") + " &&");
    EXPECT_EQ(timed.exit_code, 0) << timed.err;
}

TEST_F(ScriptGl, AClickPinsAPixelWhoseTermsAreNamed) {
    EXPECT_PLAYED(play(R"(
key P
click B/picture 150 100
hover Status
expect "Pixel probe/truth/N" "0."
expect "Pixel probe/A/worst" light
expect "Pixel probe/B/worst" "every term is right"
click "Pixel probe/copy"
expect Status Copied
key Tab
key Z
shot loupe.png
key Z
shot plain.png
key Tab
key L
shot line.png
drag A/picture 0 30
shot lower.png
)"));
    expect_other("loupe.png", "plain.png");
    expect_other("line.png", "lower.png");
}

TEST_F(ScriptGl, FindingsNeverOutliveWhatTheyAreOf) { // masks of one size over a picture of another
    EXPECT_PLAYED(play("key K\nshot masks.png\nkey 4\nwait\nkey 1\nkey 2\nkey 5\nsize 700x500\nkey 1\nwait\n"));
}

TEST_F(ScriptGl, ACaptureRestoresTheView) {
    EXPECT_PLAYED(play("key F12\nexpect Status Captured\nkey F12\n"));
    expect_same("three-point-lights-001.png", "three-point-lights-002.png");
    const ProcessResult again =
        run_sandbox({"capture", folder.file("three-point-lights-001.png.json"), "--out", folder.file("again.png")});
    EXPECT_EQ(again.exit_code, 0) << again.err;
    expect_same("again.png", "three-point-lights-001.png");
}

/// What stands in the window is what the capture holds: 16 samples a pixel once nothing moves.
TEST_F(ScriptGl, PicturesAtRestAreSmoothAndCapturedSo) {
    EXPECT_PLAYED(play("key Tab\nkey 3\nshot shown.png\nkey F12\nwait\nkey 4\nwait\nkey F12\n"));
    const Image shown = decode_png(folder.read("shown.png"), "shown.png");
    const Image captured = decode_png(folder.read("three-point-lights-001.png"), "captured");
    ASSERT_EQ(shown.size.width, captured.size.width);
    const auto lower = std::next(captured.pixels.begin(), std::ssize(captured.pixels) / 2); // has no labels
    const auto alike = [](const glm::vec4 &a, const glm::vec4 &b) { // a card rounds halves to either level
        return glm::all(glm::lessThanEqual(glm::abs(a - b), glm::vec4(1.01F / 255)));
    };
    EXPECT_NE(std::search(shown.pixels.begin(), shown.pixels.end(), lower, captured.pixels.end(), alike),
              shown.pixels.end());
    const std::string sidecar = folder.file("three-point-lights-001.png.json");
    EXPECT_NE(folder.read("three-point-lights-001.png.json").find("\"samples\": 16"), std::string::npos);
    EXPECT_EQ(run_sandbox({"capture", sidecar, "--samples", "1", "--out", folder.file("plain.png")}).exit_code, 0);
    expect_other("plain.png", "three-point-lights-001.png");
    EXPECT_EQ(folder.read("three-point-lights-002.png.json").find("\"samples\""), std::string::npos) << "a difference";
}

/// The message stands until the next key or click, also with the panels hidden, and is in no picture of the views.
TEST_F(ScriptGl, ACaptureIsSaidOnThePicture) {
    EXPECT_PLAYED(play("key Tab\nshot plain.png\nkey F12\nshot said.png\nkey F12\nwait\nkey Shift+Tab\nshot gone.png\n"
                       "key Shift+F12\n"));
    expect_other("plain.png", "said.png");
    expect_same("plain.png", "gone.png");
    expect_same("three-point-lights-001.png", "three-point-lights-002.png");
    expect_same("plain.png", "three-point-lights-window-001.png");
}

/// What needs a new program keeps the last picture until that is built aside; then it shows.
TEST_F(ScriptGl, ANewProgramIsBuiltAside) {
    EXPECT_PLAYED(play("wait\nshot before.png\nclick \"Lights/+ spot\"\nshot after.png\nlongest\n"
                       "click \"Lights/4/remove\"\nhover Status\nshot again.png\n"));
    expect_other("before.png", "after.png");
}

TEST_F(ScriptGl, ATextbookIsDrawnAside) {
    EXPECT_PLAYED(play("click Stability\nclick Stability/attenuation-kc-0-on-the-surface\nwait\n"
                       "expect A/error \"max \"\nkey 4\nshot difference.png\n"));
}

/// 4 seconds: 40 frames of a script, of which each move of the mouse takes three.
TEST_F(ScriptGl, ACapturesMessageExpires) {
    std::string moves;
    for (int i = 0; i < 14; ++i) {
        moves += "hover View/description\nhover Status\n";
    }
    EXPECT_PLAYED(play("hover Status\nkey F12\nshot said.png\nhover View/description\nhover Status\nshot still.png\n" +
                       moves + "shot gone.png\n"));
    expect_same("said.png", "still.png");
    expect_other("said.png", "gone.png");
}

TEST_F(ScriptGl, TheFolderOfCapturesOpens) {
    const std::string tool = folder.file("xdg-open");
    folder.write("xdg-open", "#!/bin/sh\nprintf '%s' \"$1\" > opened.part && mv opened.part opened\n");
    std::filesystem::permissions(tool, std::filesystem::perms::owner_all);
    folder.write("open.txt", "click Window\nclick \"Window/open the folder of captures\"\n");
    const ProcessResult result = run_sandbox({"view", "--script", "open.txt", "--no-times"},
                                             "cd " + folder.path().string() + " && PATH=.:$PATH");
    EXPECT_EQ(result.exit_code, 0) << result.err;
    for (int i = 0; i < 100 && !std::filesystem::exists(folder.file("opened")); ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(20)); // it is not waited for
    }
    EXPECT_EQ(folder.read("opened"), std::filesystem::canonical(folder.path()).string());
}

TEST_F(ScriptGl, VectorsLoupeAndProfileAreCapturedAndComeBack) {
    EXPECT_PLAYED(play("key P\nclick B/picture 150 100\nkey Z\nhover Status\nwait\nkey F12\n"
                       "key L\nkey Z\ndrag A/picture 0 0\nwait\nkey F12\n")); // one capture at a time
    for (const char *name : {"three-point-lights-001.png", "three-point-lights-002.png"}) {
        const std::string sidecar = std::string(name) + ".json";
        const ProcessResult again = run_sandbox({"capture", folder.file(sidecar), "--out", folder.file("again.png")});
        EXPECT_EQ(again.exit_code, 0) << again.err;
        expect_same("again.png", name);
    }
    expect_other("three-point-lights-001.png", "three-point-lights-002.png");
    EXPECT_PLAYED(play("expect \"Pixel probe/truth/N\" \"0.\"\nkey F12\n", {"three-point-lights-001.png.json"}));
    EXPECT_NE(folder.read("three-point-lights-001.png-001.png.json").find("\"vectors\": true"), std::string::npos);
    EXPECT_NE(folder.read("three-point-lights-001.png-001.png.json").find("\"loupe\": true"), std::string::npos);
    EXPECT_NE(folder.read("three-point-lights-002.png.json").find("\"profile\""), std::string::npos);
}

TEST_F(ScriptGl, AWipesSidecarRestoresItsDivider) {
    EXPECT_PLAYED(play("key Tab\nkey 2\ndrag View/divider 60 0\nshot wipe.png\nkey F12\n"));
    EXPECT_PLAYED(play("key Tab\nshot again.png\n", {"three-point-lights-001.png.json"}));
    expect_same("wipe.png", "again.png");
}

TEST_F(ScriptGl, ANamedTechniqueReplacesAllThatASidecarSaysOfA) {
    EXPECT_PLAYED(play("key F12\nexpect Status Captured\n"));
    std::string text = folder.read("three-point-lights-001.png.json");
    text.replace(text.find("\"layout\""), 0, "\"textbook_left\": true, ");
    folder.write("textbook.json", text);
    EXPECT_PLAYED(play("expect A/name \"flat / lambert\"\nexpect B/name \"per-pixel / phong\"\n",
                       {"textbook.json", "--left", "flat/lambert", "--right", "per-pixel/phong"}));
    EXPECT_PLAYED(play("expect A/name textbook\n", {"textbook.json"}));
}

TEST_F(ScriptGl, TheTabMeasuresWhatTheCommandMeasures) {
    EXPECT_PLAYED(play("key E\nclick \"Error vs run time/Run\"\nexpect Status Measured\n"
                       "click \"Error vs run time/Export\"\nexpect Status Exported\n",
                       {"box-1-colour"}));
    const ProcessResult merged = run_sandbox(
        {"report", "--merge", folder.file("box-1-colour-report-001/report.json"), "--out", folder.file("merged")});
    EXPECT_EQ(merged.exit_code, 0) << merged.err;
    const ProcessResult command = run_sandbox({"report", "box-1-colour", "--quick", "--out", folder.file("command")});
    EXPECT_EQ(command.exit_code, 0) << command.err;
    // The same rows with the same errors: the first eight columns, of which none is a run time.
    const auto rows = [&](const std::string &name) {
        std::istringstream in(folder.read(name));
        std::string text, line;
        while (std::getline(in, line)) {
            std::size_t end = 0;
            for (int column = 0; column < 8 && end != std::string::npos; ++column) {
                end = line.find(',', end == 0 ? 0 : end + 1);
            }
            text += line.substr(0, end) + "\n";
        }
        return text;
    };
    EXPECT_EQ(rows("command/report.csv"), rows("box-1-colour-report-001/report.csv"));
}

TEST_F(ScriptGl, TheWindowClosesWhileItMeasures) {
    EXPECT_PLAYED(play("key E\nclick \"Error vs run time/Run\"\nwait 0.5\nkey Ctrl+Q\n"));
}

TEST_F(ScriptGl, MenusTabsAndDroppedFilesOpen) {
    folder.write("bad.json", "{\"lights\": 3}");
    EXPECT_PLAYED(play(R"(
click Scene
click Scene/vase
expect Status vase
expect A/name "per-vertex / blinn-phong"
expect View/differ "A and B differ in: frequency"
click GLSL
expect "GLSL/A/line 1" "#version"
click Stability
click Stability/spot-cutoff-0
expect A/name textbook
key Ctrl+Z
expect A/name "per-vertex / blinn-phong"
click Scene
click Scene/box-4-normal-matrix
expect A/name "normals by"
drop bad.json
expect Status lights
)"));
}

TEST_F(ScriptGl, AScenesEditsAreSavedOpenedAndPasted) {
    EXPECT_PLAYED(play(R"(
drag Lights/1/diffuse 0
key Ctrl+S
type File/path mine
expect Status mine.json
key Ctrl+C
expect Status clipboard
key Ctrl+Z
expect Lights/1/diffuse 0.72
key Ctrl+V
expect Lights/1/diffuse 0.000
key Ctrl+Z
key Ctrl+O
type File/path mine.json
expect Status "Opened mine"
expect Lights/1/diffuse 0.000
key Ctrl+O
expect File/path ""
key Escape
key Ctrl+O
type File/path nothing.json
expect Status nothing.json
)",
                       {"--settings", "settings.json"}));
    EXPECT_NE(folder.read("settings.json").find("mine.json"), std::string::npos) << "a recent file";
    folder.write("bad.json", "{");
    EXPECT_PLAYED(play("expect Status \"set aside\"\n", {"--settings", "bad.json"}));
}

TEST_F(ScriptGl, TheWindowResizes) {
    EXPECT_PLAYED(play("hover Status\nshot first.png\nsize 480x320\nshot small.png\nsize 1000x560\nshot back.png\n"));
    expect_other("first.png", "small.png");
    expect_same("first.png", "back.png");
}

TEST_F(ScriptGl, SaysWhatIsWrongInWhichLine) {
    const ProcessResult unknown = play("wait\nclick Technique/A/flut\n");
    EXPECT_EQ(unknown.exit_code, 2);
    EXPECT_NE(unknown.err.find("script.txt:2: there is no widget 'Technique/A/flut'"), std::string::npos)
        << unknown.err;
    EXPECT_NE(unknown.err.find("Technique/A/flat"), std::string::npos) << unknown.err;
    EXPECT_EQ(play("jump GLSL\n").exit_code, 2);
    EXPECT_EQ(play("drag GLSL\n").exit_code, 2);
    EXPECT_EQ(play("key Strg+Z\n").exit_code, 2);
    EXPECT_EQ(play("click \"GLSL\n").exit_code, 2);
    EXPECT_EQ(play("drag GLSL 3\n").exit_code, 2);
    const ProcessResult unmet = play("\n# a comment\nexpect A/name per-pixel\n");
    EXPECT_EQ(unmet.exit_code, 1);
    EXPECT_NE(unmet.err.find("script.txt:3: expected 'A/name' to show 'per-pixel'"), std::string::npos) << unmet.err;
}

TEST_F(ScriptGl, AMonkeyFindsNoError) { EXPECT_PLAYED(play("monkey 60 7\n")); }

} // namespace
} // namespace sandbox

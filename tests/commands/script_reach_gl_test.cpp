#include "commands/script_gl.h"
#include "image/png.h"

#include <string>
#include <tuple>

/// That everything in the window can be read and reached.
namespace sandbox {
namespace {

TEST_F(ScriptGl, TheListOfKeysFitsOrScrollsByKeys) {
    EXPECT_PLAYED(play(R"(
size 1280x720
key ?
expect Keys whole
size 800x500
expect Keys scrolls
shot first.png
key PageDown
shot second.png
key Home
shot back.png
key Escape
)"));
    expect_other("first.png", "second.png");
    expect_same("first.png", "back.png");
}

/// 8 seconds: 80 frames of a script, of which each move of the mouse takes three.
TEST_F(ScriptGl, TheStatusLinesMessagesExpire) {
    std::string moves;
    for (int i = 0; i < 14; ++i) {
        moves += "hover A/picture\nhover Status\n";
    }
    EXPECT_PLAYED(play("key Ctrl+C\nexpect Status clipboard\n" + moves + "expect Status \"? lists the keys\"\n"));
}

TEST_F(ScriptGl, AProbeFollowsTheMouseWithoutPanels) {
    EXPECT_PLAYED(play(R"(
key P
key Tab
hover A/picture 300 250
wait
key F12
hover A/picture 200 300
wait
key F12
)"));
    const ProcessResult again =
        run_sandbox({"capture", folder.file("three-point-lights-002.png.json"), "--out", folder.file("again.png")});
    EXPECT_EQ(again.exit_code, 0) << again.err;
    expect_same("again.png", "three-point-lights-002.png");
    expect_other("again.png", "three-point-lights-001.png");
}

/// The edges stop at their limits, the settings keep them, and a right click brings them back.
TEST_F(ScriptGl, ThePanelsResizeByTheirEdges) {
    const Arguments kept{"--settings", "settings.json"};
    EXPECT_PLAYED(play("key P\nhover Status\nshot first.png\ndrag \"side edge\" -60 0\ndrag \"bottom edge\" 0 -80\n"
                       "hover Status\nshot dragged.png\n",
                       kept));
    EXPECT_PLAYED(play("key P\nhover Status\nshot kept.png\nright-click \"side edge\"\nright-click \"bottom edge\"\n"
                       "hover Status\nshot back.png\n",
                       kept));
    expect_other("first.png", "dragged.png");
    expect_same("dragged.png", "kept.png");
    expect_same("first.png", "back.png");
    EXPECT_PLAYED(play("drag \"side edge\" -900 0\ndrag \"side edge\" 900 0\nhover A/picture\n"
                       "click Technique/A/flat\nexpect A/name flat\n"));
}

TEST_F(ScriptGl, AFaultStandsUnderItsNameWithWhatToLookFor) {
    EXPECT_PLAYED(play(R"(
click Faults
expect Faults/gate=none "highlights on the unlit side"
click Faults/A/gate=none
expect "Faults/gate=none/look for" "shine through from behind"
)"));
}

/// Ctrl+Tab goes from panel to panel, arrows from control to control, Space presses.
TEST_F(ScriptGl, TheKeyboardReachesPanelsTabsAndMenus) {
    EXPECT_PLAYED(play(R"(
hold Ctrl
key Ctrl+Tab
release Ctrl
key Down
key Right
key Space
expect B/name flat
hold Ctrl
key Ctrl+Tab
key Ctrl+Tab
release Ctrl
key Space
key Down
key Space
expect Status Opened
)"));
}

/// Ctrl+Tab goes on from the menu bar to the edges: arrows move them, Enter brings them back.
TEST_F(ScriptGl, TheEdgesMoveByArrows) {
    const std::string to_side = "key P\nhover Status\nhold Ctrl\nkey Ctrl+Tab\nkey Ctrl+Tab\nkey Ctrl+Tab\n";
    const std::string to_bottom = to_side + "key Ctrl+Tab\n";
    for (const auto &[way, less, more] :
         {std::tuple(to_side, "key Left\n", "key Right\n"), std::tuple(to_bottom, "key Up\n", "key Down\n")}) {
        const std::string one(less), other(more);
        EXPECT_PLAYED(play(way + "release Ctrl\nshot first.png\n" + one + one + "shot moved.png\n" + other + other +
                           "shot again.png\n" + one + "key Enter\nshot back.png\n"));
        expect_other("first.png", "moved.png");
        expect_same("first.png", "again.png");
        expect_same("first.png", "back.png");
    }
}

TEST_F(ScriptGl, ADoubleClickBringsAnEdgeBack) {
    EXPECT_PLAYED(play("key P\nhover Status\nshot first.png\ndrag \"bottom edge\" 0 -60\nhover Status\n"
                       "shot dragged.png\ndouble-click \"bottom edge\"\nhover Status\nshot back.png\n"));
    expect_other("first.png", "dragged.png");
    expect_same("first.png", "back.png");
}

/// Whole titles, short ones, then a list; by the same names where they are buttons.
TEST_F(ScriptGl, TheTabsOpenInWindowsOfEverySize) {
    EXPECT_PLAYED(play(R"(
size 800x500
click "Error vs run time"
expect "Error vs run time/Run" Run
click Stability
click Stability/spot-cutoff-0
expect A/name textbook
scale 2
click tabs
click tabs/Motion
expect Motion/moment "the scene itself"
click tabs
click "tabs/no tab"
expect tabs "choose a tab"
)"));
}

/// Twice the pixels at twice the scale: the same layout, in sharper text.
TEST_F(ScriptGl, ADenseScreenKeepsTheLayout) {
    EXPECT_PLAYED(play("scale 2\nsize 2000x1120\nkey P\nshot dense.png\nexpect \"side edge\" \"side edge\"\n"));
    const Image dense = decode_png(folder.read("dense.png"), "dense.png");
    EXPECT_EQ(dense.size, (Size{2000, 1120}));
    EXPECT_EQ(play("scale 0\n").exit_code, 2);
}

/// Text of any size makes panels of any height: no black line of the surface below shows between them.
TEST_F(ScriptGl, PanelsCoverTheWindowAtEveryScale) {
    EXPECT_PLAYED(
        play("key T\nhover Status\nkey Ctrl+-\nshot 1.png\nkey Ctrl+-\nshot 2.png\nkey Ctrl+-\nshot 3.png\n"));
    for (const char *name : {"1.png", "2.png", "3.png"}) {
        const Image image = decode_png(folder.read(name), name);
        for (int y = 0; y < image.size.height; ++y) {
            EXPECT_GT(image.at(0, y).r, 0.2F) << name << ", row " << y;
        }
    }
}

/// With run times: a run is estimated when all else has been found out.
TEST_F(ScriptGl, ARunSaysAboutHowLongItWillTake) {
    folder.write("times.txt", "key E\nexpect \"Error vs run time/estimate\" \"takes about\"\n");
    const ProcessResult result =
        run_sandbox({"view", "box-1-colour", "--script", folder.file("times.txt"), "--size", "640x480"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
}

} // namespace
} // namespace sandbox

#include "commands/script_gl.h"

#include <nlohmann/json.hpp>
#include <string>

namespace sandbox {
namespace {

/// Two steps that draw little.
const std::string small_lesson = R"({"title": "Gates", "steps": [
    {"title": "One", "text": "The first.", "scene": "point-light", "left": "per-vertex/phong",
     "right": "per-pixel/phong", "layout": "side-by-side", "look": {"at": [0.5, 0.5]},
     "question": {"asks": "Why?", "answer": "Vertices."},
     "claims": [{"says": "They differ", "metric": "max_abs", "against": "right", "above": 1e-6, "size": "64x48"},
                {"says": "They agree", "metric": "max_abs", "against": "right", "below": 1e-6, "size": "64x48"},
                {"says": "It takes", "metric": "run_time", "size": "64x48"}]},
    {"title": "Two", "text": "The second.", "layout": "single", "left": "flat/phong",
     "claims": [{"metric": "brightest", "above": 0, "size": "64x48"}]}]})";

TEST_F(ScriptGl, ALessonIsSteppedThroughAndItsClaimsAreMeasured) {
    folder.write("mine.json", small_lesson);
    const ProcessResult result = play(R"(
expect Lesson/place "Step 1 of 2:  Gates"
expect Lesson/text "The first."
expect "Lesson/claim 1" "holds: "
expect "Lesson/claim 1" "claimed: above 1.00e-06: They differ"
expect "Lesson/claim 2" "does not hold: "
expect "Lesson/claim 3" "not checked: It takes"
key End
expect Lesson/answer Vertices.
key PageDown
expect Lesson/place "Step 2 of 2"
expect "Lesson/claim 1" "holds: "
key PageDown
expect Status "last step"
key PageUp
expect Lesson/place "Step 1 of 2"
click "Lesson/>"
expect Lesson/title Two
click "Lesson/End the lesson"
expect Lesson/vertex-or-pixel "Per vertex or per pixel"
)",
                                      {"mine.json"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
}

TEST_F(ScriptGl, AChangedStepSaysSoAndComesBackUndoneOrRestored) {
    folder.write("mine.json", small_lesson);
    EXPECT_PLAYED(play(R"(
wait
key Tab
shot first.png
key 2
key Tab
expect Lesson/changed "You have changed this step."
key Home
key Tab
shot restored.png
key PageDown
wait
shot second.png
key Ctrl+Z
wait
shot undone.png
)",
                       {"mine.json"}));
    expect_same("first.png", "restored.png");
    expect_other("first.png", "second.png");
    expect_same("first.png", "undone.png");
}

/// The ring is in the window and in the capture, and the capture's sidecar has it.
TEST_F(ScriptGl, TheRingIsCapturedAsShown) {
    folder.write("mine.json", small_lesson);
    EXPECT_PLAYED(play("wait\nkey Tab\nkey F12\nwait\nkey PageDown\nwait\nkey F12\nwait\n", {"mine.json"}));
    const auto ring = nlohmann::json::parse(folder.read("mine-01-001.png.json"))["ring"];
    ASSERT_EQ(ring.size(), 3U);
    EXPECT_NEAR(ring[0].get<double>(), 0.5, 1e-12);
    EXPECT_NEAR(ring[1].get<double>(), 0.5, 1e-12);
    EXPECT_FALSE(nlohmann::json::parse(folder.read("mine-02-001.png.json")).contains("ring"));
}

TEST_F(ScriptGl, ADroppedLessonOpensAndABadOneChangesNothing) {
    folder.write("mine.json", small_lesson);
    folder.write("bad.json", R"({"title": "x", "steps": [{"titel": "y"}]})");
    EXPECT_PLAYED(play(R"(
drop mine.json
expect Lesson/place "Step 1 of 2"
drop bad.json
expect Status "bad.json: steps[0].titel: unknown key of this step"
expect Lesson/place "Step 1 of 2"
)"));
}

TEST_F(ScriptGl, BuiltInLessonsAndBugsOpenByMenuAndName) {
    EXPECT_PLAYED(play(R"(
click Lesson
click Lesson/normal-matrix
expect Lesson/place "Step 1 of 7"
click Lesson
click "Famous bugs"
click Lesson/highlight-in-the-dark
expect Lesson/Seen "A bright spot"
)"));
    EXPECT_PLAYED(play("expect Lesson/place \"Step 1 of\"\n", {"--lesson", "two-sided"}));
    const ProcessResult wrong = play("wait\n", {"--lesson", "two-sidde"});
    EXPECT_EQ(wrong.exit_code, 2);
    EXPECT_NE(wrong.err.find("did you mean \"two-sided\"?"), std::string::npos) << wrong.err;
}

TEST_F(ScriptGl, AStepShowsAnotherTabBesideItsText) {
    EXPECT_PLAYED(play(R"(
expect Lesson/place "Step 1 of 5"
size 1280x720
expect "Error vs run time/Run" Run
expect Lesson/place "Step 1 of 5"
)",
                       {"--lesson", "error-and-run-time"}));
}

/// Page down scrolls the list of keys while it is open, and is the lesson's again behind it.
TEST_F(ScriptGl, TheListOfKeysKeepsThePageKeys) {
    folder.write("mine.json", small_lesson);
    EXPECT_PLAYED(play(R"(
key ?
key PageDown
expect Lesson/place "Step 1 of 2"
key ?
key PageDown
expect Lesson/place "Step 2 of 2"
)",
                       {"mine.json"}));
}

TEST_F(ScriptGl, WhatMovesInAClaimIsPlayedFromItsStep) {
    EXPECT_PLAYED(play(R"(
click Lesson/steps
click "Lesson/steps/6  In motion"
click Lesson/Play
play 3
key A
key O
expect Motion/moment "moment 3 of"
)",
                       {"--lesson", "vertex-or-pixel"}));
}

/// With the panels hidden, for a presenter's remote.
TEST_F(ScriptGl, TheGalleryIsGoneThroughFromBugToBug) {
    EXPECT_PLAYED(play(R"(
key Tab
key PageDown
expect A/name "per-pixel / blinn-phong"
key PageUp
expect A/name "highlights on the unlit side"
)",
                       {"--lesson", "highlight-in-the-dark"}));
}

TEST_F(ScriptGl, ProgressIsKeptInTheSettings) {
    folder.write("mine.json", small_lesson);
    EXPECT_PLAYED(play("key PageDown\n", {"mine.json", "--settings", "settings.json"}));
    const auto kept = nlohmann::json::parse(folder.read("settings.json"))["lessons"];
    EXPECT_EQ(kept["step"], 1);
    EXPECT_EQ(kept["seen"][kept["last"].get<std::string>()], (std::vector<int>{0, 1}));
    EXPECT_PLAYED(play("key B\nclick Lesson/Continue\nexpect Lesson/place \"Step 2 of 2\"\n",
                       {"point-light", "--settings", "settings.json"}));
}

} // namespace
} // namespace sandbox

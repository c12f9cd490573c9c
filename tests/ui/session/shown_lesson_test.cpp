#include "ui/session/shown_lesson.h"

#include "teach/lesson_read.h"
#include "ui/session/session.h"

#include <gtest/gtest.h>

namespace sandbox {
namespace {

/// A session of a scene of its own, with a lesson of three steps at hand.
class ShownLessonTest : public testing::Test {
  protected:
    void show(std::size_t number) { show_step(session, lesson, "mine", number); }
    void edit() {
        session.document.scene.lights[0].diffuse *= 0.5;
        session.history.record(session.document);
    }
    [[nodiscard]] std::size_t number() const { return session.document.step->number; }

    const Assets assets{"assets"};
    const std::shared_ptr<const Lesson> lesson =
        std::make_shared<const Lesson>(parse_lesson(R"({"title": "T", "steps": [
        {"title": "a", "text": "x", "scene": "point-light", "left": "flat/lambert", "right": "per-pixel/lambert",
         "layout": "wipe", "mesh_factors": [0.5, 1], "exposure": 2, "look": {"at": [0.5, 0.5]}, "asserts": false},
        {"title": "b", "text": "x", "layout": "difference", "gain": 8, "normals": true, "display": "srgb",
         "asserts": false},
        {"title": "c", "text": "x", "claims": [{"metric": "max_abs", "above": 0,
          "motion": {"mover": "object", "index": 0, "from": 0, "to": 90, "seconds": 1, "course": "turn"}}]}]})",
                                                    "mine.json", {}, assets, {}));
    const Document own = document_of("own", lesson->steps[0].scene, {}, {});
    Session session{own};
};

TEST_F(ShownLessonTest, AStepSetsSceneTechniquesAndView) {
    show(0);
    EXPECT_EQ(session.document.left, parse_technique("flat/lambert"));
    EXPECT_EQ(session.document.mesh_factors, (MeshFactors{0.5, 1}));
    EXPECT_EQ(session.document.exposure, 2);
    EXPECT_EQ(session.view.layout, Layout::wipe);
    go_on(session, 1);
    EXPECT_EQ(session.view.layout, Layout::difference);
    EXPECT_EQ(session.view.gain, 8);
    EXPECT_EQ(session.view.drawn_over, (Overlays{.normals = true}));
    EXPECT_EQ(session.document.display, Display::srgb);
    EXPECT_EQ(session.document.exposure, 1);
    EXPECT_FALSE(step_is_changed(session));
}

TEST_F(ShownLessonTest, TheEndsOfALessonAreSaid) {
    show(2);
    go_on(session, 1);
    EXPECT_EQ(number(), 2U);
    EXPECT_EQ(session.message.text, "This is the lesson's last step.");
    go_to_step(session, 0);
    go_on(session, -1);
    EXPECT_EQ(number(), 0U);
    EXPECT_EQ(session.message.text, "This is the lesson's first step.");
}

TEST_F(ShownLessonTest, ChangesAreNoticedAndTakenBack) {
    show(1);
    edit();
    EXPECT_TRUE(step_is_changed(session));
    restore_step(session);
    EXPECT_FALSE(step_is_changed(session));
    EXPECT_EQ(number(), 1U);
    for (const auto &change :
         {+[](Session &s) { s.view.layout = Layout::single; }, +[](Session &s) { s.view.gain = 2; },
          +[](Session &s) { s.view.drawn_over.wireframe = true; },
          +[](Session &s) { s.document.right.model = Model::phong; }, +[](Session &s) { s.document.exposure = 3; },
          +[](Session &s) { s.document.scene.camera.position.x += 1; }}) {
        change(session);
        EXPECT_TRUE(step_is_changed(session));
        restore_step(session);
        EXPECT_FALSE(step_is_changed(session));
    }
}

TEST_F(ShownLessonTest, WhatDoesNotShowIsNoChange) {
    show(0);
    session.view.gain = 7; // of a difference, and this is a wipe
    EXPECT_FALSE(step_is_changed(session));
    const Document before = session.document;
    restore_step(session);
    EXPECT_EQ(session.document, before) << "nothing to take back, no edit";
}

TEST_F(ShownLessonTest, AStepIsOneEditWithItsView) {
    session.view.layout = Layout::three_up;
    show(0);
    go_on(session, 1);
    undo(session);
    EXPECT_EQ(number(), 0U);
    EXPECT_EQ(session.view.layout, Layout::wipe);
    EXPECT_FALSE(step_is_changed(session));
    undo(session);
    EXPECT_EQ(session.document, own);
    EXPECT_EQ(session.view.layout, Layout::three_up);
    redo(session);
    redo(session);
    EXPECT_EQ(number(), 1U);
    EXPECT_EQ(session.view.layout, Layout::difference);
    EXPECT_FALSE(step_is_changed(session));
}

TEST_F(ShownLessonTest, UndoInsideAStepStaysInIt) {
    show(0);
    session.view.layout = Layout::single;
    edit();
    undo(session);
    EXPECT_EQ(number(), 0U);
    EXPECT_EQ(session.view.layout, Layout::single) << "the view is no part of that edit";
}

TEST_F(ShownLessonTest, ProgressIsKept) {
    show(0);
    go_to_step(session, 2);
    EXPECT_EQ(session.progress, (LessonProgress{"mine", 2, {{"mine", {0, 2}}}}));
    undo(session);
    EXPECT_EQ(session.progress.step, 0U);
}

TEST_F(ShownLessonTest, WhatMovesInAClaimCanBePlayed) {
    show(2);
    EXPECT_EQ(session.playback.motion, *lesson->steps[2].claims[0].motion);
    EXPECT_FALSE(session.playback.playing);
}

TEST_F(ShownLessonTest, TheRingIsShownUntilTheCameraMoves) {
    show(0);
    ASSERT_TRUE(shown_ring(session, {400, 300}));
    EXPECT_NEAR(shown_ring(session, {400, 300})->x, 0.5, 1e-12);
    edit();
    EXPECT_TRUE(shown_ring(session, {400, 300}));
    session.document.scene.camera.position.x += 1;
    EXPECT_FALSE(shown_ring(session, {400, 300}));
    go_on(session, 1);
    EXPECT_FALSE(shown_ring(session, {400, 300})) << "this step has none";
}

/// The gallery is gone through from bug to bug, and ends where it ends.
TEST_F(ShownLessonTest, BehindABugsLastStepComesTheNextBug) {
    session.lessons = {{"a", "A"}, {"mine", "M", true}, {"b", "B", true}};
    show(2);
    go_on(session, 1);
    EXPECT_EQ(session.requests.open_lesson, "b");
    EXPECT_EQ(session.requests.open_step, 0U);
    session.requests = {};
    show(0);
    go_on(session, -1);
    EXPECT_FALSE(session.requests.open_lesson) << "before the first bug is a lesson";
    show_step(session, lesson, "b", 0);
    go_on(session, -1);
    EXPECT_EQ(session.requests.open_lesson, "mine");
    EXPECT_GT(session.requests.open_step, 2U) << "from behind";
    session.requests = {};
    show_step(session, lesson, "a", 2);
    go_on(session, 1);
    EXPECT_FALSE(session.requests.open_lesson) << "a lesson ends";
}

TEST_F(ShownLessonTest, TheNextStepIsKnownAhead) {
    show(0);
    EXPECT_EQ(next_document(session).left, *lesson->steps[1].left);
    EXPECT_EQ(next_view(session).layout, Layout::difference);
    show(2);
    EXPECT_EQ(next_document(session), session.document);
}

} // namespace
} // namespace sandbox

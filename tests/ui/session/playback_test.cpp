#include "ui/session/session.h"

#include <gtest/gtest.h>

namespace sandbox {
namespace {

Session lit_session() {
    Scene scene;
    scene.lights.push_back({});
    scene.lights[0].position = {2, 2, 0};
    return Session(document_of("lit", scene, {}, {}));
}

TEST(Playback, NeverChangesTheDocument) {
    Session session = lit_session();
    const Document before = session.document;
    play_or_pause(session);
    for (int i = 0; i < 60; ++i) {
        next_moment(session);
        session.history.record(session.document); // as every frame does
    }
    EXPECT_EQ(session.document, before);
    EXPECT_FALSE(session.history.can_undo());
    EXPECT_NE(shown_document(session).scene, before.scene);
    EXPECT_EQ(shown_document(session).scene, moved(before.scene, session.playback.motion, 60));
    stop_motion(session);
    EXPECT_EQ(shown_document(session), before);
}

TEST(Playback, PausedItStandsAndStepsBothWays) {
    Session session = lit_session();
    play_or_pause(session);
    next_moment(session);
    play_or_pause(session);
    next_moment(session);
    EXPECT_EQ(session.playback.moment, 1) << "paused";
    step_motion(session, -2);
    EXPECT_EQ(session.playback.moment, moments_of(session.playback.motion) - 1);
    step_motion(session, 1);
    EXPECT_EQ(shown_document(session).scene, session.document.scene);
    EXPECT_TRUE(session.playback.shown);
}

TEST(Playback, WhatIsKeptIsOneStep) {
    Session session = lit_session();
    const Document before = session.document;
    step_motion(session, 40);
    const Document shown = shown_document(session);
    keep_moment(session);
    EXPECT_EQ(session.document, shown);
    EXPECT_EQ(shown_document(session), shown) << "no longer in motion";
    undo(session);
    EXPECT_EQ(session.document, before);
    EXPECT_FALSE(session.history.can_undo());
}

TEST(Playback, StopsWithAMessageWhereTheSceneLosesWhatMoves) {
    Session session = lit_session();
    play_or_pause(session);
    session.document.scene.lights.clear();
    EXPECT_EQ(shown_document(session), session.document);
    next_moment(session);
    EXPECT_FALSE(session.playback.playing || session.playback.shown);
    EXPECT_TRUE(session.message.error);
    play_or_pause(session);
    EXPECT_FALSE(session.playback.playing);
}

TEST(Playback, ASliderRunsFromWhereItIsToItsEndAndBack) {
    Session session = lit_session();
    choose_motion(session, {.mover = Mover::number, .path = "lights[0].specular"});
    EXPECT_EQ(session.playback.motion.from, 1);
    EXPECT_EQ(session.playback.motion.to, 2);
    EXPECT_EQ(session.playback.motion.course, Course::to_and_fro);
    choose_motion(session, {.mover = Mover::camera, .to = 1});
    EXPECT_EQ(session.playback.motion, Motion{.mover = Mover::camera});
}

} // namespace
} // namespace sandbox

#include "ui/session/history.h"

#include <gtest/gtest.h>

namespace sandbox {
namespace {

Document with_diffuse(double diffuse) {
    Document document;
    document.scene.lights = {Light{}};
    document.scene.lights[0].diffuse = diffuse;
    return document;
}

Document moved(Document document, double x) {
    document.scene.camera.position.x = x;
    return document;
}

TEST(History, GoesBackAndForthOverEdits) {
    History history(with_diffuse(1));
    history.record(with_diffuse(0.5));
    history.record(with_diffuse(0.2));
    EXPECT_EQ(history.undo(), with_diffuse(0.5));
    EXPECT_EQ(history.undo(), with_diffuse(1));
    EXPECT_FALSE(history.can_undo());
    EXPECT_EQ(history.undo(), with_diffuse(1));
    EXPECT_EQ(history.redo(), with_diffuse(0.5));
    EXPECT_EQ(history.redo(), with_diffuse(0.2));
    EXPECT_FALSE(history.can_redo());
    EXPECT_EQ(history.redo(), with_diffuse(0.2));
}

TEST(History, WhatIsEqualIsNoStep) {
    History history(with_diffuse(1));
    history.record(with_diffuse(1));
    EXPECT_FALSE(history.can_undo());
}

TEST(History, AnEditAfterUndoForgetsWhatWasUndone) {
    History history(with_diffuse(1));
    history.record(with_diffuse(0.5));
    history.undo();
    history.record(with_diffuse(0.3));
    EXPECT_FALSE(history.can_redo());
    EXPECT_EQ(history.undo(), with_diffuse(1));
}

TEST(History, CoversTechniquesAndDisplay) {
    Document document = with_diffuse(1);
    History history(document);
    document.left.model = Model::phong;
    history.record(document);
    document.exposure = 2;
    history.record(document);
    EXPECT_EQ(history.undo().exposure, 1);
    EXPECT_EQ(history.undo().left.model, Model::blinn_phong);
}

TEST(History, CameraMovesInARowAreOneStep) {
    History history(with_diffuse(1));
    history.record(with_diffuse(0.5));
    for (int i = 1; i <= 20; ++i) {
        history.record(moved(with_diffuse(0.5), i));
    }
    EXPECT_EQ(history.undo(), with_diffuse(0.5));
    EXPECT_EQ(history.undo(), with_diffuse(1));
    EXPECT_FALSE(history.can_undo());
}

TEST(History, AnEditBetweenCameraMovesKeepsThemApart) {
    History history(with_diffuse(1));
    history.record(moved(with_diffuse(1), 1));
    history.record(moved(with_diffuse(0.5), 1));
    history.record(moved(with_diffuse(0.5), 2));
    EXPECT_EQ(history.undo(), moved(with_diffuse(0.5), 1));
    EXPECT_EQ(history.undo(), moved(with_diffuse(1), 1));
    EXPECT_EQ(history.undo(), with_diffuse(1));
}

TEST(History, TheFirstCameraMoveCanBeUndone) {
    History history(with_diffuse(1));
    history.record(moved(with_diffuse(1), 1));
    history.record(moved(with_diffuse(1), 2));
    EXPECT_EQ(history.undo(), with_diffuse(1));
}

TEST(History, ForgetsTheOldestBeyondItsLimit) {
    History history(with_diffuse(0));
    for (int i = 1; i <= 1000; ++i) {
        history.record(with_diffuse(i));
    }
    int steps = 0;
    while (history.can_undo()) {
        history.undo();
        ++steps;
    }
    EXPECT_EQ(steps, 499);
    EXPECT_EQ(history.current(), with_diffuse(501));
}

} // namespace
} // namespace sandbox

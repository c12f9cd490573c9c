#include "image/error.h"
#include "render/own_process.h"
#include "scene/scene_file.h"
#include "tools/error_of.h"
#include "tools/temporary_folder.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

/// What becomes of own shading whose process does not answer; shell commands stand in for it. Needs no OpenGL.
namespace sandbox {
namespace {

class OwnProcessEnds : public testing::Test {
  protected:
    Scene scene = open_scene("point-light", Assets("assets"));
    Technique technique = parse_technique_with(
        OwnShader("a.glsl", "vec3 lighting(vec3 P, vec3 N, vec3 eye) { return vec3(0.5); }"), "per-pixel/own");

    std::string failure(OwnProcess &own) {
        return error_of([&] { own.picture(scene, technique, {8, 8}, false); });
    }
    std::string failure_of(const std::string &script) {
        OwnProcess own({"/bin/sh", "-c", script});
        return failure(own);
    }
};

TEST_F(OwnProcessEnds, ADriversCrashIsTheTextsFailure) {
    EXPECT_EQ(failure_of("kill -SEGV $$"),
              "a.glsl: the process that compiled and drew it was ended by signal 11 (Segmentation fault)");
    EXPECT_EQ(failure_of("exit 7"), "a.glsl: the process that compiled and drew it ended without a picture");
}

TEST_F(OwnProcessEnds, AnEndlessOneIsEndedByTheKernel) {
    EXPECT_EQ(failure_of("ulimit -t 1; while :; do :; done"),
              "a.glsl: took more than 5 s of processor time to compile and draw");
}

TEST_F(OwnProcessEnds, WhatFailedIsNotTriedAgain) {
    const TemporaryFolder folder;
    const std::string starts = folder.file("starts");
    OwnProcess own({"/bin/sh", "-c", fmt::format("echo started >> '{}'", starts)});
    const std::string first = failure(own);
    EXPECT_EQ(failure(own), first);
    EXPECT_EQ(folder.read("starts"), "started\n");
    scene.ambient = glm::dvec3(0.5); // may let the text through
    EXPECT_EQ(failure(own), first);
    EXPECT_EQ(folder.read("starts"), "started\nstarted\n");
}

TEST_F(OwnProcessEnds, NoProcessIsTheMachinesFailure) {
    OwnProcess own({"/nowhere/shading-sandbox", "own-server"});
    try {
        failure(own);
        FAIL();
    } catch (const MachineError &error) {
        EXPECT_STREQ(error.what(),
                     "/nowhere/shading-sandbox: cannot be started to draw own shading: No such file or directory");
    }
}

} // namespace
} // namespace sandbox

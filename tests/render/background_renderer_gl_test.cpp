#include "render/background_renderer.h"
#include "scene/scene_file.h"
#include "tools/gl_test.h"

#include <EGL/egl.h>
#include <atomic>
#include <latch>
#include <string>
#include <thread>

namespace sandbox {
namespace {

class BackgroundRendererGl : public GlTest {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        if (!IsSkipped() && !HasFatalFailure()) {
            shared.emplace(context(), Assets("assets"), Assets("shaders"));
            shared->make_context();
            display = eglGetCurrentDisplay();
        }
    }
    void TearDown() override {
        shared.reset();
        GlTest::TearDown();
    }

    std::optional<BackgroundRenderer> shared;
    EGLDisplay display = EGL_NO_DISPLAY;
};

Frame small_frame(Renderer &renderer) {
    return renderer.render(open_scene("vase", Assets("assets")), Technique{}, {32, 24});
}

TEST_F(BackgroundRendererGl, DrawsWhatTheFirstRendererDraws) {
    Renderer renderer(Assets("assets"), ShaderParts(Assets("shaders")));
    const Frame here = small_frame(renderer);
    Frame aside;
    std::jthread([&] {
        BackgroundRenderer::Turn turn(*shared, {});
        aside = small_frame(turn.renderer());
    }).join();
    EXPECT_EQ(here.color.pixels, aside.color.pixels);
}

/// llvmpipe walks through the frames of every context of a display while other threads draw them.
TEST_F(BackgroundRendererGl, SharesNoDisplayWithASoftwareWindow) {
    if (!Context::software()) {
        GTEST_SKIP() << "a GPU's driver draws for several threads";
    }
    EGLDisplay aside = EGL_NO_DISPLAY;
    std::jthread([&] {
        const BackgroundRenderer::Turn turn(*shared, {});
        aside = eglGetCurrentDisplay();
    }).join();
    EXPECT_NE(aside, EGL_NO_DISPLAY);
    EXPECT_NE(aside, display);
}

/// The second one asks while the first one draws, and gets its turn when the first one offers it, before it goes on.
TEST_F(BackgroundRendererGl, LetsWhoWaitsDrawFirst) {
    std::string order;
    std::latch drawing(1);
    std::jthread first([&] {
        BackgroundRenderer::Turn turn(*shared, {});
        turn.let_others_draw(); // nobody waits
        order += "a";
        drawing.count_down();
        while (shared->waiting() == 0) {
            std::this_thread::yield();
        }
        order += "b";
        turn.let_others_draw();
        small_frame(turn.renderer());
        order += "d";
    });
    std::jthread second([&] {
        drawing.wait();
        BackgroundRenderer::Turn turn(*shared, {});
        small_frame(turn.renderer());
        order += "c";
    });
    first.join();
    second.join();
    EXPECT_EQ(order, "abcd");
}

TEST_F(BackgroundRendererGl, WhoIsStoppedWhileWaitingDoesNotDraw) {
    std::latch drawing(1), stopped(1);
    std::jthread first([&] {
        const BackgroundRenderer::Turn turn(*shared, {});
        drawing.count_down();
        stopped.wait();
    });
    drawing.wait();
    std::atomic<bool> drew = true;
    {
        std::jthread second([&](const std::stop_token &stop) {
            const BackgroundRenderer::Turn turn(*shared, stop);
            drew = static_cast<bool>(turn);
        });
        while (shared->waiting() == 0) {
            std::this_thread::yield();
        }
        second.request_stop();
    }
    EXPECT_FALSE(drew);
    stopped.count_down();
    first.join();
    {
        const BackgroundRenderer::Turn third(*shared, {}); // nothing is left of the second one
        EXPECT_TRUE(static_cast<bool>(third));
    }
    context().make_current();
}

} // namespace
} // namespace sandbox

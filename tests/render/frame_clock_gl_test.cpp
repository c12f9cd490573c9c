#include "render/frame_clock.h"

#include "render/renderer.h"
#include "scene/scene_file.h"
#include "tools/gl_test.h"

#include <cmath>
#include <cstdio>
#include <glad/gl.h>
#include <string>

namespace sandbox {
namespace {

class FrameClocks : public GlTest {
  protected:
    void draw(Target &target) { renderer_.draw(scene_, {}, target); }

    Renderer renderer_{Assets("assets"), ShaderParts(Assets("shaders"))};
    Scene scene_ = open_scene("three-point-lights", Assets("assets"));
};

TEST(FrameClock, ATimerThatSeesHalfTheWorkOrMoreThanTheWallClockIsNotBelieved) {
    EXPECT_TRUE(clocks_agree(48, 50));
    EXPECT_FALSE(clocks_agree(25, 50));
    EXPECT_FALSE(clocks_agree(0.4, 43)); // llvmpipe, as it was found
    EXPECT_FALSE(clocks_agree(60, 50));
}

TEST_F(FrameClocks, SoftwareRenderersKeepToTheWallClock) {
    int draws = 0;
    Target target({160, 120});
    FrameClock clock(true, target, [&] { ++draws; });
    EXPECT_EQ(draws, 0);
    EXPECT_EQ(clock.name(), "wall clock around draw and glFinish");
    EXPECT_GT(clock.milliseconds([&] { draw(target); }), 0);
}

TEST_F(FrameClocks, WhicheverClockIsChosenGivesATimeForEveryFrame) {
    Target target({160, 120});
    FrameClock clock(false, target, [&] { draw(target); });
    const double milliseconds = clock.milliseconds([&] { draw(target); });
    EXPECT_TRUE(std::isfinite(milliseconds));
    EXPECT_GE(milliseconds, 0);
    EXPECT_EQ(glGetError(), 0U);
    std::printf("chosen: %s\n", std::string(clock.name()).c_str());
}

} // namespace
} // namespace sandbox

#include "capture/frame_names.h"

#include "image/error.h"

#include <gtest/gtest.h>

namespace sandbox {
namespace {

TEST(Orbit, FramesDivideTheTurnSoThatItLoops) {
    EXPECT_EQ(orbit_degrees(360, 0, 4), 0);
    EXPECT_EQ(orbit_degrees(360, 3, 4), 270);
    EXPECT_EQ(orbit_degrees(-90, 1, 2), -45);
}

TEST(FramePattern, OneIntegerConversion) {
    EXPECT_EQ(frame_name("a_%04d.png", 7), "a_0007.png");
    EXPECT_EQ(frame_name("a_%04d.png", 12345), "a_12345.png");
    EXPECT_EQ(frame_name("%d.pfm", 0), "0.pfm");
    EXPECT_EQ(frame_name("100%%_%02d.png", 3), "100%_03.png");
}

TEST(FramePattern, AnythingElseIsRefused) {
    for (const char *pattern : {"a.png", "%d_%d.png", "%s.png", "%04x.png", "%4d.png", "%00d.png", "%010d.png",
                                "%n%d.png", "%d%", "%%d.png", "%-4d.png", "%ld.png", "% d.png", "%"}) {
        EXPECT_THROW(frame_name(pattern, 1), InputError) << pattern;
    }
}

TEST(FramePattern, IsSeenInAName) {
    EXPECT_TRUE(is_frame_pattern("a_%04d.png"));
    EXPECT_TRUE(is_frame_pattern("%d"));
    EXPECT_FALSE(is_frame_pattern("100%.png"));
    EXPECT_FALSE(is_frame_pattern("%%d.png"));
}

TEST(Turntable, ItsSidecarHoldsIt) {
    const std::string text = turntable_text(R"({"techniques": ["flat/phong"], "scene": {}})", {24, 360});
    EXPECT_EQ(turntable_of(text, "t.json"), (Turntable{24, 360}));
    EXPECT_FALSE(turntable_of(R"({"techniques": ["flat/phong"], "scene": {}})", "t.json"));
    for (const char *wrong : {R"({"scene": {}, "frames": 3})", R"({"scene": {}, "frames": 0, "orbit_degrees": 3})",
                              R"({"scene": {}, "frames": "3", "orbit_degrees": 3})",
                              R"({"scene": {}, "frames": 3, "orbit_degrees": 2e9})"}) {
        EXPECT_THROW(turntable_of(wrong, "t.json"), InputError) << wrong;
    }
}

TEST(MotionSidecar, HoldsTheMotionBesideTheScene) {
    const Motion motion{.mover = Mover::light, .index = 2, .from = -30, .to = 30, .course = Course::to_and_fro};
    const std::string text = motion_sidecar(R"({"techniques": ["flat/phong"], "scene": {}})", motion);
    EXPECT_EQ(motion_of(text, "a.json"), motion);
    EXPECT_EQ(motion_of(R"({"techniques": [], "scene": {}})", "a.json"), std::nullopt);
    EXPECT_EQ(motion_of("no JSON", "a.json"), std::nullopt);
    EXPECT_THROW(motion_of(R"({"scene": {}, "motion": {"mover": "sun"}})", "a.json"), InputError);
}

} // namespace
} // namespace sandbox

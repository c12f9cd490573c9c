#include "capture/orbit.h"

#include "image/error.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace sandbox {
namespace {

// A few rounding errors of double in a product of coordinates near 10.
constexpr double tolerance = 1e-14;

void expect_near(glm::dvec3 a, glm::dvec3 b) {
    EXPECT_LT(glm::distance(a, b), tolerance * 10) << a.x << " " << a.y << " " << a.z;
}

Camera camera_at(glm::dvec3 position) {
    Camera camera;
    camera.position = position;
    camera.target = {1, 2, 3};
    return camera;
}

TEST(Orbit, ZeroIsTheCameraItself) {
    const Camera camera = camera_at({0.1, 0.7, 6.3});
    EXPECT_EQ(orbit_camera(camera, 0), camera);
}

TEST(Orbit, AQuarterTurnIsCounterClockwiseSeenFromAbove) {
    // From +z (towards the viewer) to +x, at the same height.
    const Camera turned = orbit_camera(camera_at({1, 4, 8}), 90);
    expect_near(turned.position, {6, 4, 3});
    EXPECT_EQ(turned.target, glm::dvec3(1, 2, 3));
    EXPECT_EQ(turned.up, glm::dvec3(0, 1, 0));
}

TEST(Orbit, HalfAndWholeTurns) {
    expect_near(orbit_camera(camera_at({1, 4, 8}), 180).position, {1, 4, -2});
    expect_near(orbit_camera(camera_at({1, 4, 8}), 360).position, {1, 4, 8});
    expect_near(orbit_camera(camera_at({1, 4, 8}), -90).position, {-4, 4, 3});
}

TEST(Orbit, TurnsAboutTheCamerasOwnUpWhateverItsLength) {
    Camera camera = camera_at({6, 2, 3});
    camera.up = {0, 0, 20};
    expect_near(orbit_camera(camera, 90).position, {1, 7, 3});
}

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

} // namespace
} // namespace sandbox

#include "scene/orbit.h"
#include "scene/space.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace sandbox {
namespace {

constexpr double rounding = 1e-12; // a few dozen double operations on numbers near 10

double distance_of(const Camera &camera) { return glm::length(camera.position - camera.target); }

void expect_near(glm::dvec3 a, glm::dvec3 b, double tolerance) {
    EXPECT_LT(glm::length(a - b), tolerance)
        << a.x << " " << a.y << " " << a.z << " against " << b.x << " " << b.y << " " << b.z;
}

TEST(Turntable, PoseIsRightForAxes) {
    Camera camera;
    camera.position = {0, 0, 6};
    EXPECT_NEAR(orbit_pose(camera).azimuth_degrees, 0, rounding);
    EXPECT_NEAR(orbit_pose(camera).elevation_degrees, 0, rounding);
    EXPECT_NEAR(orbit_pose(camera).distance, 6, rounding);
    camera.position = {6, 0, 0};
    EXPECT_NEAR(orbit_pose(camera).azimuth_degrees, 90, 1e-10);
    camera.position = {0, 3, 3};
    EXPECT_NEAR(orbit_pose(camera).elevation_degrees, 45, 1e-10);
}

TEST(Turntable, PoseAndBackIsTheSameCamera) {
    Camera camera;
    camera.position = {3, -2, 5};
    camera.target = {1, 1, -1};
    camera.up = {0.3, 2, 0.1};
    expect_near(at_pose(camera, orbit_pose(camera)).position, camera.position, 1e-10);
}

TEST(Turntable, TurnsAboutTheTargetAndKeepsTheDistance) {
    Camera camera;
    camera.target = {1, 0, 0};
    camera.position = {1, 0, 6};
    const Camera turned = orbited(camera, 90, 0);
    expect_near(turned.position, {7, 0, 0}, 1e-10);
    EXPECT_EQ(turned.target, camera.target);
    EXPECT_EQ(turned.up, camera.up);
    EXPECT_NEAR(distance_of(orbited(camera, 33, -21)), 6, 1e-10);
}

TEST(Turntable, AWholeTurnComesHome) {
    Camera camera;
    Camera turned = camera;
    for (int i = 0; i < 36; ++i) {
        turned = orbited(turned, 10, 0);
    }
    expect_near(turned.position, camera.position, 1e-9);
}

TEST(Turntable, NeverFlipsOverAPole) {
    Camera camera;
    camera.position = {0, 0, 6};
    for (int i = 0; i < 100; ++i) {
        const glm::dvec3 right_before = camera_axes(camera).right;
        camera = orbited(camera, 0, 5);
        EXPECT_LE(orbit_pose(camera).elevation_degrees, most_elevation_degrees + 1e-9);
        EXPECT_GT(glm::dot(right_before, camera_axes(camera).right), 0.99) << "after " << i << " steps";
    }
    for (int i = 0; i < 200; ++i) {
        camera = orbited(camera, 0, -5);
    }
    EXPECT_NEAR(orbit_pose(camera).elevation_degrees, -most_elevation_degrees, 1e-9);
}

TEST(Turntable, LeavesAPlanViewWithoutAJump) {
    for (const double side : {1.0, -1.0}) {
        Camera camera; // looks along its up vector: azimuth means nothing there
        camera.position = {0, 6 * side, 0};
        const CameraAxes before = camera_axes(camera);
        const Camera tilted = orbited(camera, 0, -2 * side);
        EXPECT_NEAR(distance_of(tilted), 6, 1e-10);
        EXPECT_GT(glm::dot(camera_axes(tilted).up, before.up), 0.99);
        EXPECT_GT(glm::dot(camera_axes(tilted).right, before.right), 0.99);
    }
}

TEST(Turntable, DollyScalesTheDistanceAndStaysBetweenTheClipPlanes) {
    Camera camera;
    camera.position = {0, 0, 6};
    EXPECT_NEAR(distance_of(dollied(camera, 0.5)), 3, rounding);
    for (int i = 0; i < 200; ++i) {
        camera = dollied(camera, 0.9);
    }
    EXPECT_GT(distance_of(camera), camera.near_plane);
    for (int i = 0; i < 400; ++i) {
        camera = dollied(camera, 1.1);
    }
    EXPECT_LT(distance_of(camera), camera.far_plane);
}

TEST(Turntable, PanMovesByPictureHeights) {
    Camera camera;
    camera.position = {0, 0, 6};
    camera.fov_y_degrees = 90; // at the target the picture is 12 high
    const Camera panned_right = panned(camera, 0.5, 0);
    expect_near(panned_right.position, {6, 0, 6}, 1e-10);
    expect_near(panned_right.target, {6, 0, 0}, 1e-10);
    expect_near(panned(camera, 0, -0.25).target, {0, -3, 0}, 1e-10);
}

TEST(Turntable, StaysWithinAScenesCoordinates) {
    Camera camera;
    camera.far_plane = 1e15;
    camera.position = {0, 0, 9e8};
    for (int i = 0; i < 50; ++i) {
        camera = panned(dollied(camera, 1.5), 1, 1);
    }
    for (int i = 0; i < 3; ++i) {
        EXPECT_LE(std::abs(camera.position[i]), 1e10);
        EXPECT_LE(std::abs(camera.target[i]), 1e10);
    }
}

TEST(Turntable, ACameraInItsTargetStaysThere) {
    Camera camera;
    camera.position = camera.target;
    EXPECT_EQ(orbited(camera, 10, 10), camera);
    EXPECT_EQ(dollied(camera, 2), camera);
}

// A few rounding errors of double in a product of coordinates near 10.
void expect_at(glm::dvec3 a, glm::dvec3 b) { expect_near(a, b, 1e-13); }

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
    expect_at(turned.position, {6, 4, 3});
    EXPECT_EQ(turned.target, glm::dvec3(1, 2, 3));
    EXPECT_EQ(turned.up, glm::dvec3(0, 1, 0));
}

TEST(Orbit, HalfAndWholeTurns) {
    expect_at(orbit_camera(camera_at({1, 4, 8}), 180).position, {1, 4, -2});
    expect_at(orbit_camera(camera_at({1, 4, 8}), 360).position, {1, 4, 8});
    expect_at(orbit_camera(camera_at({1, 4, 8}), -90).position, {-4, 4, 3});
}

TEST(Orbit, TurnsAboutTheCamerasOwnUpWhateverItsLength) {
    Camera camera = camera_at({6, 2, 3});
    camera.up = {0, 0, 20};
    expect_at(orbit_camera(camera, 90).position, {1, 7, 3});
}

TEST(Orthographic, TheWheelChangesTheHeightAndNothingElse) {
    const Camera camera = with_projection(Camera{}, Projection::orthographic);
    Camera expected = camera;
    expected.height *= 0.5;
    EXPECT_EQ(dollied(camera, 0.5), expected);
    EXPECT_EQ(dollied(camera, 0).height, camera.height);
    EXPECT_EQ(dollied(camera, 1e300).height, 1e9) << "the file's range holds";
}

TEST(Orthographic, APanFollowsThePicture) {
    Camera camera{.position = {0, 0, 6}};
    camera.projection = Projection::orthographic;
    camera.height = 4;
    EXPECT_EQ(panned(camera, 0.25, 0).target, glm::dvec3(1, 0, 0));
}

TEST(Orthographic, TheOtherProjectionShowsAsMuchAtTheTarget) {
    const Camera perspective{.position = {0, 0, 6}, .fov_y_degrees = 90};
    const Camera orthographic = with_projection(perspective, Projection::orthographic);
    EXPECT_NEAR(orthographic.height, 12, 1e-12);
    EXPECT_EQ(orthographic.fov_y_degrees, Camera{}.fov_y_degrees);
    const Camera back = with_projection(orthographic, Projection::perspective);
    EXPECT_NEAR(back.fov_y_degrees, 90, 1e-12);
    EXPECT_EQ(back.height, 0);
    EXPECT_EQ(with_projection(perspective, Projection::perspective), perspective);
}

} // namespace
} // namespace sandbox

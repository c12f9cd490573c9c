#include "scene/space.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace sandbox {
namespace {

// Some roundings of numbers near 1, each 1.1e-16.
constexpr double rounding = 1e-15;

void expect_near(const glm::dvec3 &got, const glm::dvec3 &expected, double tolerance = rounding) {
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(got[i], expected[i], tolerance) << "component " << i;
    }
}

TEST(LinearPart, QuarterTurnsAreExact) {
    EXPECT_EQ(linear_part({.rotate_degrees = {90, 0, 0}}) * glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1));
    EXPECT_EQ(linear_part({.rotate_degrees = {0, 90, 0}}) * glm::dvec3(0, 0, 1), glm::dvec3(1, 0, 0));
    EXPECT_EQ(linear_part({.rotate_degrees = {0, 0, 90}}) * glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0));
    EXPECT_EQ(linear_part({.rotate_degrees = {0, 0, 180}}) * glm::dvec3(1, 2, 3), glm::dvec3(-1, -2, 3));
    EXPECT_EQ(linear_part({.rotate_degrees = {0, 0, -90}}) * glm::dvec3(1, 0, 0), glm::dvec3(0, -1, 0));
    EXPECT_EQ(linear_part({.rotate_degrees = {0, 0, 360e6 + 90}}) * glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0));
}

TEST(LinearPart, ScalesFirstThenTurnsAboutTheFixedAxesXFirst) {
    // (1, 1, 1) scaled: (1, 2, 3); about x by 90: (1, -3, 2); about y by 90: (2, -3, -1); about z by 90: (3, 2, -1).
    const Transform transform{.rotate_degrees = {90, 90, 90}, .scale = {1, 2, 3}};
    EXPECT_EQ(linear_part(transform) * glm::dvec3(1), glm::dvec3(3, 2, -1));
}

TEST(LinearPart, TurnsByAnyAngle) {
    const double root = std::sqrt(0.5);
    expect_near(linear_part({.rotate_degrees = {45, 0, 0}}) * glm::dvec3(0, 1, 0), {0, root, root});
    expect_near(linear_part({.rotate_degrees = {0, 30, 0}}) * glm::dvec3(1, 0, 0), {std::sqrt(0.75), 0, -0.5});
    expect_near(linear_part({.rotate_degrees = {0, 0, 150}}) * glm::dvec3(1, 0, 0), {-std::sqrt(0.75), 0.5, 0});
}

TEST(CameraAxes, LookAlongMinusZByDefault) {
    const CameraAxes axes = camera_axes({.position = {0, 0, 5}, .target = {0, 0, 0}});
    EXPECT_EQ(axes.forward, glm::dvec3(0, 0, -1));
    EXPECT_EQ(axes.right, glm::dvec3(1, 0, 0));
    EXPECT_EQ(axes.up, glm::dvec3(0, 1, 0));
}

TEST(CameraAxes, AreOrthonormalAndRightHandedWhateverUpIs) {
    const glm::dvec3 ups[] = {{0, 1, 0}, {0, -2, 0}, {3, 3, 3}, {1e-200, 0, 0}, {0, 0, 1e200}, {-1, -1, -1}};
    const glm::dvec3 targets[] = {{0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {1, 1, 1}, {1e9, -1e9, 1e9}, {1e-9, 0, 0}};
    for (const glm::dvec3 &up : ups) {
        for (const glm::dvec3 &target : targets) {
            const CameraAxes axes = camera_axes({.position = {0, 0, 0}, .target = target, .up = up});
            EXPECT_NEAR(glm::length(axes.right), 1, rounding);
            EXPECT_NEAR(glm::length(axes.up), 1, rounding);
            EXPECT_NEAR(glm::dot(axes.right, axes.forward), 0, rounding);
            expect_near(glm::cross(axes.right, axes.up), -axes.forward);
        }
    }
}

TEST(ViewProjection, MapsTheFrustumToTheClipCube) {
    // fov 90, aspect 2: at depth d the frustum is 2 d high and 4 d wide.
    const Camera camera{
        .position = {7, 8, 9}, .target = {7, 8, 8}, .fov_y_degrees = 90, .near_plane = 1, .far_plane = 3};
    const glm::dmat4 matrix = view_projection(camera, 2);
    const auto clip = [&](glm::dvec3 from_eye) {
        const glm::dvec4 p = matrix * glm::dvec4(from_eye, 1);
        return glm::dvec3(p) / p.w;
    };
    expect_near(clip({0, 0, -1}), {0, 0, -1});
    expect_near(clip({0, 0, -3}), {0, 0, 1});
    expect_near(clip({2, 1, -1}), {1, 1, -1});
    expect_near(clip({-6, 3, -3}), {-1, 1, 1});
    // z = (f + n) / (f - n) - 2 f n / ((f - n) d) = 2 - 3 / d, at d = 2.
    expect_near(clip({0, 0, -2}), {0, 0, 0.5});
    EXPECT_NEAR((matrix * glm::dvec4(0, 0, -2, 1)).w, 2, rounding);
}

TEST(ViewProjection, TurnsWithTheCamera) {
    const Camera camera{
        .position = {0, 0, 0}, .target = {5, 0, 0}, .fov_y_degrees = 90, .near_plane = 1, .far_plane = 3};
    const glm::dvec4 p = view_projection(camera, 1) * glm::dvec4(2, 1, 2, 1); // ahead, above and to the right
    EXPECT_NEAR(p.x / p.w, 1, rounding);
    EXPECT_NEAR(p.y / p.w, 0.5, rounding);
}

TEST(ViewProjection, OrthographicIsLinearAlongEveryAxis) {
    Camera camera{.position = {7, 8, 9}, .target = {7, 8, 8}, .near_plane = 1, .far_plane = 3};
    camera.projection = Projection::orthographic;
    camera.height = 4;
    const glm::dmat4 clip = view_projection(camera, 1.5);
    const glm::dvec4 corner = clip * glm::dvec4(3, 2, -1, 1); // from the eye: the upper right corner of the near plane
    const glm::dvec4 middle = clip * glm::dvec4(0, 0, -2, 1);
    for (int i = 0; i < 4; ++i) {
        EXPECT_NEAR(corner[i], (glm::dvec4(1, 1, -1, 1)[i]), 1e-15);
        EXPECT_NEAR(middle[i], (glm::dvec4(0, 0, 0, 1)[i]), 1e-15);
    }
    EXPECT_NEAR((clip * glm::dvec4(0, -2, -3, 1)).z, 1, 1e-15);
}

TEST(BackFaces, AnOrthographicCameraHidesThemBehindItsNearPlane) {
    const Mesh ball = build_mesh(SphereShape{});
    Camera camera{.position = {0, 0, 5}, .near_plane = 0.1};
    camera.projection = Projection::orthographic;
    camera.height = 400; // however much it shows
    EXPECT_TRUE(back_faces_hidden(camera, 2, {}, ball));
    camera.near_plane = 3.9;
    EXPECT_TRUE(back_faces_hidden(camera, 2, {}, ball));
    camera.near_plane = 4.1;
    EXPECT_FALSE(back_faces_hidden(camera, 2, {}, ball));
    EXPECT_FALSE(back_faces_hidden(camera, 2, {.rotate_degrees = {10, 20, 30}, .scale = {1, 1, 2}}, ball));
}

} // namespace
} // namespace sandbox

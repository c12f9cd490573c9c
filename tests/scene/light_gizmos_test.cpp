#include "scene/light_gizmos.h"
#include "scene/space.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

namespace sandbox {
namespace {

constexpr double rounding = 1e-9; // of some dozen operations in double, an arc sine near 1 among them
constexpr double aspect = 2;

/// From (0, 0, 8) along -z, 90 degrees high: at a depth d the picture shows 2 d, and 4 d of the width.
Scene seen_by(Projection projection) {
    Scene scene;
    scene.camera.position = {0, 0, 8};
    scene.camera.fov_y_degrees = 90;
    if (projection == Projection::orthographic) {
        scene.camera.projection = projection;
        scene.camera.height = 16;
    }
    return scene;
}

Light light_at(const glm::dvec3 &position, LightType type = LightType::point) {
    Light light;
    light.type = type;
    light.position = position;
    return light;
}

void expect_near(const glm::dvec2 &a, const glm::dvec2 &b) {
    EXPECT_LT(glm::distance(a, b), rounding) << a.x << " " << a.y << ", " << b.x << " " << b.y;
}
void expect_near(const glm::dvec3 &a, const glm::dvec3 &b) {
    EXPECT_LT(glm::distance(a, b), rounding)
        << a.x << " " << a.y << " " << a.z << ", " << b.x << " " << b.y << " " << b.z;
}

TEST(LightGizmos, APointLightLiesWhereItIsSeen) {
    Scene scene = seen_by(Projection::perspective);
    scene.lights = {light_at({4, 2, 0}), light_at({4, 2, 4})};
    const auto gizmos = light_gizmos(scene, aspect);
    ASSERT_EQ(gizmos.size(), 2U);
    expect_near(gizmos[0].lamp, {0.5 + 4.0 / 32, 0.5 - 2.0 / 16});
    expect_near(gizmos[1].lamp, {0.5 + 4.0 / 16, 0.5 - 2.0 / 8}); // half as far away
    EXPECT_FALSE(gizmos[0].to);
    EXPECT_TRUE(gizmos[0].lines.empty());
}

TEST(LightGizmos, WhatIsOffOutOfThePictureOrBehindIsNotThere) {
    Scene scene = seen_by(Projection::perspective);
    scene.lights = {light_at({0, 0, 9}), light_at({0, 8.1, 0}), light_at({16.1, 0, 0}), light_at({0, 0, 0}),
                    light_at({0, 0, 1})};
    scene.lights[3].enabled = false;
    const auto gizmos = light_gizmos(scene, aspect);
    ASSERT_EQ(gizmos.size(), 1U);
    EXPECT_EQ(gizmos[0].light, 4U);
}

TEST(LightGizmos, ADirectionalLightsArrowPointsAtTheTarget) {
    Scene scene = seen_by(Projection::orthographic);
    scene.camera.target = {0, 0, -3};
    scene.lights = {light_at({}, LightType::directional)};
    scene.lights[0].direction = {0, -2, 0};
    const auto gizmos = light_gizmos(scene, aspect);
    ASSERT_EQ(gizmos.size(), 1U);
    expect_near(gizmos[0].lamp, {0.5, 0.1}); // 0.4 of the height above the middle
    expect_near(*gizmos[0].from, {0.5, 0.1});
    expect_near(*gizmos[0].to, {0.5, 0.34}); // 0.4 of the way is left
    EXPECT_FALSE(gizmos[0].turns);
}

TEST(LightGizmos, ASpotsConeOpensByItsAngles) {
    Scene scene = seen_by(Projection::orthographic);
    Light spot = light_at({0, 0, 0}, LightType::spot);
    spot.direction = {0, -3, 0};
    spot.cutoff_degrees = 30;
    spot.inner_cutoff_degrees = 20;
    scene.lights = {spot};
    const LightGizmo gizmo = light_gizmos(scene, aspect).at(0);
    const double arm = 0.25; // of the height
    expect_near(*gizmo.to, {0.5, 0.5 + arm});
    ASSERT_EQ(gizmo.lines.size(), 3U);
    const auto expect_circle = [&](const std::vector<glm::dvec2> &circle, double degrees) {
        double widest = 0;
        for (const glm::dvec2 &p : circle) {
            EXPECT_NEAR(p.y, 0.5 + arm * std::cos(glm::radians(degrees)), rounding); // seen from its edge
            widest = std::max(widest, std::abs(p.x - 0.5));
        }
        EXPECT_NEAR(widest, arm * std::sin(glm::radians(degrees)) / aspect, 1e-3 * arm); // at one of 64 points
    };
    expect_circle(gizmo.lines[0], 30);
    expect_circle(gizmo.lines[2], 20);
    ASSERT_EQ(gizmo.lines[1].size(), 3U);
    expect_near(gizmo.lines[1][1], gizmo.lamp);
    scene.lights[0].cutoff_degrees = 180; // shines everywhere
    const LightGizmo everywhere = light_gizmos(scene, aspect).at(0);
    EXPECT_FALSE(everywhere.to);
    EXPECT_TRUE(everywhere.lines.empty());
}

TEST(LightGizmos, ALampMovesInThePlaneOfThePicture) {
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        Scene scene = seen_by(projection);
        scene.lights = {light_at({4, 2, 0})};
        const Light moved = dragged_light(scene, 0, LightHandle::lamp, aspect, {0.25, -0.125});
        expect_near(moved.position, glm::dvec3(4 + 32 * 0.25, 2 + 16 * 0.125, 0));
        EXPECT_EQ(moved.direction, scene.lights[0].direction);
    }
}

/// A tilted camera; every kind of light, dragged a little: the handle is where the mouse is.
TEST(LightGizmos, AHandleFollowsTheMouse) {
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        for (const LightType type : {LightType::point, LightType::spot, LightType::directional}) {
            Scene scene = seen_by(projection);
            scene.camera.position = {3, 4, 8};
            scene.camera.target = {0.5, 0, 1};
            Light light = light_at({1, 0.5, 0.3}, type);
            light.direction = {-0.1, 0.3, 0.8}; // towards the eye, so that no drag comes near the outline
            scene.lights = {light};
            const LightHandle handle = type == LightType::spot ? LightHandle::tip : LightHandle::lamp;
            const auto place = [&] {
                const LightGizmo gizmo = light_gizmos(scene, aspect).at(0);
                return handle == LightHandle::tip ? *gizmo.to : gizmo.lamp;
            };
            for (const glm::dvec2 by : {glm::dvec2(0.01, -0.02), glm::dvec2(-0.03, 0.01), glm::dvec2(0.02, 0.03)}) {
                const glm::dvec2 before = place();
                scene.lights[0] = dragged_light(scene, 0, handle, aspect, by);
                expect_near(place(), before + by);
                EXPECT_NEAR(glm::length(scene.lights[0].direction), glm::length(light.direction), rounding);
            }
        }
    }
}

TEST(LightGizmos, OverTheEdgeATailGoesBehind) {
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        Scene scene = seen_by(projection);
        scene.lights = {light_at({}, LightType::directional)};
        scene.lights[0].direction = {0, 0, -1}; // from the camera: the tail is in the middle, near
        const double radius = 0.4 * 16, depth = 8;
        const double radius_kept = projection == Projection::perspective ? std::min(radius, 0.6 * depth) : radius;
        const double outline = projection == Projection::perspective
                                   ? std::tan(std::asin(radius_kept / depth)) / 2 // at a depth of 1 the height is 2
                                   : radius_kept / 16;
        const auto direction = [&](double up) {
            return dragged_light(scene, 0, LightHandle::lamp, aspect, {0, -up}).direction;
        };
        const double edge = projection == Projection::perspective ? std::asin(radius_kept / depth) : 0;
        EXPECT_LT(glm::distance(direction(outline), glm::dvec3(0, -std::cos(edge), -std::sin(edge))), 1e-6);
        EXPECT_LT(glm::distance(direction(outline * (1 - 1e-9)), direction(outline * (1 + 1e-9))), 1e-3)
            << "a root of what is left of the radius, 2e-9 of it on each side";
        EXPECT_LT(direction(outline * 0.9).z, direction(outline).z);
        EXPECT_GT(direction(outline * 1.1).z, direction(outline).z);
        expect_near(direction(100), glm::dvec3(0, 0, 1)); // as far as it goes: straight against the view
    }
}

TEST(LightGizmos, ALampStaysInTheWorld) {
    Scene scene = seen_by(Projection::orthographic);
    scene.camera.height = 1e9;
    scene.lights = {light_at({9e8, 0, 0})};
    EXPECT_EQ(dragged_light(scene, 0, LightHandle::lamp, aspect, {0.9, 0}).position, glm::dvec3(9e8, 0, 0));
}

} // namespace
} // namespace sandbox

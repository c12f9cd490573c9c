#include "scene/scene_format.h"
#include "ui/session/ranges.h"

#include <gtest/gtest.h>

namespace sandbox {
namespace {

/// The scene file's range of a key of T.
template <class T, class M> Range format_range(M T::*member) {
    Range found;
    for_each_field<T>([&](const auto &field) {
        if constexpr (std::is_same_v<decltype(field.member), M T::*>) {
            found = field.member == member ? field.range : found;
        }
    });
    return found;
}

/// All that a control can set is accepted, and its slider stays inside.
void expect_inside(const ControlRange &control, const Range &file, const char *what) {
    EXPECT_TRUE(file.above_low ? control.low > file.low : control.low >= file.low) << what;
    EXPECT_LE(control.high, file.high) << what;
    EXPECT_GE(control.slider_low, control.low) << what;
    EXPECT_LE(control.slider_high, control.high) << what;
    EXPECT_LT(control.slider_low, control.slider_high) << what;
}

TEST(Ranges, StayWithinTheSceneFile) {
    expect_inside(ranges::intensity, format_range(&Light::diffuse), "intensity");
    expect_inside(ranges::shininess, format_range(&Material::shininess), "shininess");
    expect_inside(ranges::blinn_exponent_scale, format_range(&Scene::blinn_exponent_scale), "blinn_exponent_scale");
    expect_inside(ranges::spot_exponent, format_range(&Light::exponent), "exponent");
    expect_inside(ranges::cutoff_degrees, format_range(&Light::cutoff_degrees), "cutoff_degrees");
    expect_inside(ranges::attenuation, format_range(&Attenuation::linear), "attenuation");
    expect_inside(ranges::coordinate, format_range(&Light::position), "position");
    expect_inside(ranges::direction, format_range(&Light::direction), "direction");
    expect_inside(ranges::angle_degrees, format_range(&Transform::rotate_degrees), "rotate_degrees");
    expect_inside(ranges::scale, format_range(&Transform::scale), "scale");
    expect_inside(ranges::length, format_range(&SphereShape::radius), "radius");
    expect_inside(ranges::fov_y_degrees, format_range(&Camera::fov_y_degrees), "fov_y_degrees");
    expect_inside(ranges::rings, format_range(&SphereShape::rings), "sphere.rings");
    expect_inside(ranges::segments, format_range(&SphereShape::segments), "sphere.segments");
    expect_inside(ranges::segments, format_range(&TorusShape::rings), "torus.rings");
    expect_inside(ranges::bands, format_range(&CylinderShape::rings), "cylinder.rings");
    expect_inside(ranges::box_divisions, format_range(&BoxShape::divisions), "box.divisions");
    expect_inside(ranges::plane_divisions, format_range(&PlaneShape::divisions), "plane.divisions");
    expect_inside(ranges::cells, format_range(&Checker::cells), "cells");
}

TEST(Ranges, ReachWhatIsWorthReaching) {
    EXPECT_EQ(ranges::intensity.high, format_range(&Light::diffuse).high);
    EXPECT_EQ(ranges::shininess.high, format_range(&Material::shininess).high);
    EXPECT_EQ(ranges::attenuation.low, format_range(&Attenuation::quadratic).low);
    EXPECT_EQ(ranges::scale.low, format_range(&Transform::scale).low);
}

} // namespace
} // namespace sandbox

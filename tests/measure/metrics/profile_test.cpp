#include "measure/metrics/profile.h"

#include <glm/vec3.hpp>
#include <gtest/gtest.h>

namespace sandbox {
namespace {

/// The weights are exact sums of the colour's channels, so that 1e-12 is rounding.
TEST(Profile, IsTheLuminanceOfOneRow) {
    Image image({3, 2}, glm::vec4(0.25F, 0.25F, 0.25F, 1));
    image.at(0, 1) = {1, 0, 0, 1};
    image.at(1, 1) = {0, 1, 0, 1};
    image.at(2, 1) = {0, 0, 2, 1};
    const Curve curve = luminance_row(image, 1);
    ASSERT_EQ(curve.size(), 3U);
    EXPECT_NEAR(curve[0], 0.2126, 1e-12);
    EXPECT_NEAR(curve[1], 0.7152, 1e-12);
    EXPECT_NEAR(curve[2], 2 * 0.0722, 1e-12) << "brighter than a screen shows";
    EXPECT_NEAR(luminance_row(image, 0)[1], 0.25, 1e-12);
    EXPECT_TRUE(luminance_row(image, 2).empty()) << "below the picture";
    EXPECT_EQ(luminance(glm::dvec3(1)), 0.2126 + 0.7152 + 0.0722);
}

} // namespace
} // namespace sandbox

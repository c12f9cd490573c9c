#include "image/difference.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>

namespace sandbox {
namespace {

TEST(Difference, ColoursRunFromBlueOverWhiteToOrange) {
    EXPECT_EQ(difference_color(0), glm::vec3(1));
    EXPECT_EQ(difference_color(1), glm::vec3(0.85F, 0.37F, 0.01F));
    EXPECT_EQ(difference_color(-1), glm::vec3(0.13F, 0.35F, 0.75F));
    EXPECT_EQ(difference_color(7), difference_color(1));
    EXPECT_EQ(difference_color(-1e30F), difference_color(-1));
}

/// A step from 0 to 1/9 of the light is a third in lightness: a quarter darker on both sides of it, 0.75 * 255 = 191.
TEST(Difference, EqualPicturesShowAFaintOutline) {
    Image picture({6, 1}, glm::vec4(0, 0, 0, 1));
    for (int x = 3; x < 6; ++x) {
        picture.at(x, 0) = glm::vec4(glm::vec3(1.0F / 9 + 1e-6F), 1);
    }
    const ByteImage shown = difference_picture(picture, picture, 1000);
    const std::vector<int> expected{255, 255, 191, 191, 255, 255};
    for (std::size_t x = 0; x < 6; ++x) {
        EXPECT_EQ(shown.rgb[3 * x], expected[x]) << x;
        EXPECT_EQ(shown.rgb[3 * x + 2], expected[x]) << x;
    }
    EXPECT_EQ(largest_difference(picture, picture), 0);
}

TEST(Difference, TheChannelThatDiffersMostIsShown) {
    const Image a({1, 1}, glm::vec4(0.5F, 0.25F, 0.5F, 1)), b({1, 1}, glm::vec4(0.375F, 0.5F, 0.5F, 1));
    EXPECT_EQ(largest_difference(a, b), 0.25);
    EXPECT_EQ(difference_picture(a, b, 4).rgb, (std::vector<std::uint8_t>{33, 89, 191})); // green: -1
}

TEST(Difference, WhatIsNotFiniteIsMagentaAndInfinitelyFar) {
    const Image a({1, 1}, glm::vec4(0.5F)), b({1, 1}, glm::vec4(0.5F, std::numeric_limits<float>::quiet_NaN(), 0, 1));
    EXPECT_EQ(difference_picture(a, b, 1).rgb, (std::vector<std::uint8_t>{255, 0, 255}));
    EXPECT_EQ(largest_difference(a, b), std::numeric_limits<double>::infinity());
}

} // namespace
} // namespace sandbox

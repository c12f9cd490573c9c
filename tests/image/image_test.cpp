#include "image/image.h"

#include <gtest/gtest.h>
#include <limits>

namespace sandbox {
namespace {

Image one_pixel(float r, float g, float b) { return Image({1, 1}, {r, g, b, 1}); }

using Bytes = std::vector<std::uint8_t>;

TEST(ToDisplay, RoundsToTheNearestLevel) {
    // 0.1 / 255 is nearer to level 0, 0.6 / 255 to level 1, 254.4 / 255 to level 254.
    EXPECT_EQ(to_display(one_pixel(0.1F / 255, 0.6F / 255, 254.4F / 255)).rgb, (Bytes{0, 1, 254}));
    for (int level = 0; level < 256; ++level) {
        const auto value = static_cast<float>(level) / 255;
        EXPECT_EQ(to_display(one_pixel(value, value, value)).rgb[0], level);
    }
}

TEST(ToDisplay, ClampsToWhatAScreenShows) { EXPECT_EQ(to_display(one_pixel(-3, 7, 1e30F)).rgb, (Bytes{0, 255, 255})); }

TEST(ToDisplay, MultipliesByTheExposureFirst) {
    EXPECT_EQ(to_display(one_pixel(0.25F, 0.5F, 2), Display::linear, 0.5).rgb, (Bytes{32, 64, 255}));
}

TEST(ToDisplay, FollowsTheSrgbCurve) {
    // Closed forms of IEC 61966-2-1: 12.92 * 0.002 * 255 = 6.59; (1.055 * 0.5^(1/2.4) - 0.055) * 255 = 187.5.
    EXPECT_EQ(to_display(one_pixel(0.002F, 0.5F, 1), Display::srgb).rgb, (Bytes{7, 188, 255}));
}

TEST(ToDisplay, ShowsWhatIsNotFiniteInMagenta) {
    const Bytes magenta{255, 0, 255};
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    EXPECT_EQ(to_display(one_pixel(0, nan, 0)).rgb, magenta);
    EXPECT_EQ(to_display(one_pixel(infinity, 0, 0)).rgb, magenta);
    EXPECT_EQ(to_display(one_pixel(0, 0, -infinity), Display::srgb, 0).rgb, magenta);
}

} // namespace
} // namespace sandbox

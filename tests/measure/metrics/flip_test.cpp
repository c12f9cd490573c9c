#include "measure/metrics/flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <stdexcept>

namespace sandbox {
namespace {

ByteImage uniform(Size size, std::uint8_t r, std::uint8_t g, std::uint8_t b) {
    ByteImage image{size, {}};
    for (int i = 0; i < size.width * size.height; ++i) {
        for (const std::uint8_t channel : {r, g, b}) {
            image.rgb.push_back(channel);
        }
    }
    return image;
}

template <class Color> ByteImage painted(Size size, const Color &color) {
    ByteImage image{size, {}};
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            for (const int channel : color(x, y)) {
                image.rgb.push_back(static_cast<std::uint8_t>(channel % 256));
            }
        }
    }
    return image;
}

ByteImage noise(int seed) {
    return painted({32, 24}, [=](int x, int y) {
        return std::array{x * 37 + y * 11 + seed * 53, x * x + 3 * y + seed * 29,
                          255 - x * 7 - y * 5 + seed * 17 + 256};
    });
}

/// A bright square on a ramp.
ByteImage square(int left) {
    return painted({32, 24}, [=](int x, int y) {
        const bool in = x >= left && x < left + 8 && y >= 8 && y < 16;
        return in ? std::array{240, 230, 90} : std::array{x * 4, y * 6, 80};
    });
}

// The published tool computes in float32; agreement is asked for to 1e-4.
constexpr double tolerance = 1e-5;

TEST(Flip, IdenticalPicturesShowNothing) { EXPECT_EQ(mean_flip(noise(3), noise(3)), 0); }

TEST(Flip, GreenAgainstBlueIsTheLargestDifference) {
    EXPECT_NEAR(mean_flip(uniform({8, 8}, 0, 255, 0), uniform({8, 8}, 0, 0, 255)), 1, tolerance);
}

/// Uniform pictures have no features and filtering leaves them: HyAB(black, white) = 100, put through the knee.
TEST(Flip, BlackAgainstWhite) {
    EXPECT_NEAR(mean_flip(uniform({9, 5}, 0, 0, 0), uniform({9, 5}, 255, 255, 255)), 0.9673797612827307, tolerance);
}

/// One level of grey: L* = 42.3746 and 42.7781, below the knee: 0.95 (dL)^0.7 / (0.4 * 41.28...).
TEST(Flip, OneLevelOfGrey) {
    EXPECT_NEAR(mean_flip(uniform({9, 5}, 100, 100, 100), uniform({9, 5}, 101, 101, 101)), 0.03078356251290709,
                tolerance);
}

/// Expected values: the paper's formulas evaluated with full two-dimensional filters in double precision.
TEST(Flip, AgreesWithTheDirectTwoDimensionalEvaluation) {
    EXPECT_NEAR(mean_flip(noise(0), noise(1)), 0.5397066580238578, tolerance);
    EXPECT_NEAR(mean_flip(square(10), square(11)), 0.11003997352488094, tolerance);
    const std::vector<float> map = flip_map(noise(0), noise(1));
    EXPECT_NEAR(map[0], 0.8037820343572586, 10 * tolerance);
    EXPECT_NEAR(map[12 * 32 + 16], 0.4921168175682296, 10 * tolerance);
    EXPECT_NEAR(*std::max_element(map.begin(), map.end()), 0.973116768564743, 10 * tolerance);
}

TEST(Flip, IsSymmetric) { EXPECT_NEAR(mean_flip(square(8), square(12)), mean_flip(square(12), square(8)), 1e-7); }

TEST(Flip, GrowsWithTheDifferenceAndStaysWithinOne) {
    double last = 0;
    for (const int level : {1, 4, 16, 64, 128}) {
        const auto byte = static_cast<std::uint8_t>(100 + level);
        const double flip = mean_flip(uniform({8, 8}, 100, 100, 100), uniform({8, 8}, byte, byte, byte));
        EXPECT_GT(flip, last);
        last = flip;
    }
    for (const float value : flip_map(noise(1), noise(7))) {
        EXPECT_GE(value, 0);
        EXPECT_LE(value, 1);
    }
}

TEST(Flip, ADifferenceSpreadsNoFartherThanItsFilters) {
    ByteImage one = uniform({64, 64}, 100, 100, 100);
    ByteImage other = one;
    std::fill_n(other.rgb.begin() + 3 * (32 * 64 + 32), 3, std::uint8_t{255});
    const std::vector<float> map = flip_map(one, other);
    EXPECT_GT(map[32 * 64 + 32], 0.1);
    EXPECT_EQ(map[32 * 64 + 32 + 11], 0); // radius 10 at 67 pixels a degree
    EXPECT_EQ(map[(32 - 11) * 64 + 32], 0);
}

/// Seen from farther away (more pixels a degree) fine noise blurs out of sight.
TEST(Flip, DistanceHidesFineDifferences) {
    const auto speckle = [](int seed) {
        return painted({48, 48}, [=](int x, int y) {
            const int v = ((x + y + seed) % 2) * 40 + 100;
            return std::array{v, v, v};
        });
    };
    EXPECT_LT(mean_flip(speckle(0), speckle(1), 130), mean_flip(speckle(0), speckle(1), 30));
}

TEST(Flip, SizesMustAgreeAndNothingIsNothing) {
    EXPECT_THROW(mean_flip(uniform({2, 3}, 0, 0, 0), uniform({3, 2}, 0, 0, 0)), std::invalid_argument);
    EXPECT_EQ(mean_flip({}, {}), 0);
    EXPECT_GT(mean_flip(uniform({1, 1}, 0, 0, 0), uniform({1, 1}, 255, 0, 0)), 0.5);
}

} // namespace
} // namespace sandbox

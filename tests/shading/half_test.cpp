#include "shading/half.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace sandbox {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// By hand: a half has 11 binary digits, so that numbers in [2^k, 2^(k + 1)) are multiples of 2^(k - 10).
TEST(Half, HasElevenDigits) {
    EXPECT_EQ(to_half(1.0 / 3), 1365.0 / 4096); // 1365.33 times 2^-12
    EXPECT_EQ(to_half(0.1), 1638.0 / 16384);    // 1638.4 times 2^-14
    EXPECT_EQ(to_half(1000.5), 1000.5);         // multiples of 1/2 there
    EXPECT_EQ(to_half(1000.7), 1000.5);
    EXPECT_EQ(to_half(-3.14159265), -3.140625); // 1608.5 times 2^-9, a little less
}

TEST(Half, RoundsTiesToEven) {
    EXPECT_EQ(to_half(2049), 2048); // between 1024 and 1025 times 2
    EXPECT_EQ(to_half(2051), 2052);
    EXPECT_EQ(to_half(1 + 0x1p-11), 1);
    EXPECT_EQ(to_half(1 + 0x1p-11 + 0x1p-40), 1 + 0x1p-10);
}

TEST(Half, EndsAt65504) {
    EXPECT_EQ(to_half(65504), 65504);
    EXPECT_EQ(to_half(65519.99), 65504);
    EXPECT_EQ(to_half(65520), infinite);
    EXPECT_EQ(to_half(-1e30), -infinite);
    EXPECT_EQ(to_half(256.0 * 256.0), infinite) << "the square of a distance of 256";
    EXPECT_TRUE(std::isnan(to_half(std::nan(""))));
}

TEST(Half, HasNoSubnormals) {
    EXPECT_EQ(to_half(0x1p-14), 0x1p-14);
    EXPECT_EQ(to_half(0x1p-14 - 0x1p-26), 0x1p-14) << "nearer to it than to the subnormal below";
    EXPECT_EQ(to_half(0x1p-14 - 0x1p-25), 0x1p-14) << "the tie goes to even";
    EXPECT_EQ(to_half(0x1p-14 - 0x1p-24), 0);
    EXPECT_EQ(to_half(1e-5), 0);
    EXPECT_TRUE(std::signbit(to_half(-1e-5)));
}

} // namespace
} // namespace sandbox

#include "reference/half_numbers.h"

#include <gtest/gtest.h>
#include <limits>

namespace sandbox::reference {
namespace {

Number half(double value) { return rounded(value, false); }
Triple half(double x, double y, double z) { return {half(x), half(y), half(z)}; }

TEST(HalfNumbers, AnOperationIsAsPreciseAsItsMostPreciseOperand) {
    const Number third = half(1) / half(3);
    EXPECT_EQ(third.value, 1365.0 / 4096);
    EXPECT_FALSE(third.high);
    const Number high = half(1) / Number{3, true};
    EXPECT_EQ(high.value, 1.0 / 3);
    EXPECT_TRUE(high.high);
    EXPECT_EQ((1.0 / 3 * Number{1, true}).value, 1.0 / 3) << "a number of the text takes on what it meets";
    EXPECT_EQ((1.0 / 3 * half(1)).value, 1365.0 / 4096);
    EXPECT_EQ(max(half(-1), 1e-6).value, 0) << "1e-6 is no half";
}

TEST(HalfNumbers, DotRoundsItsProductsAndSums) {
    // 2048 + 1 is a tie and goes to 2048, twice; all at once it would be 2050.
    EXPECT_EQ(dot(half(2048, 1, 1), half(1, 1, 1)).value, 2048);
}

TEST(HalfNumbers, LengthsEndAt256) {
    EXPECT_EQ(length(half(255, 0, 0)).value, 255); // 65025 rounds to 65024, whose root to 255
    EXPECT_EQ(length(half(256, 0, 0)).value, std::numeric_limits<double>::infinity());
    EXPECT_EQ(normalize(half(256, 0, 0)).x.value, 0);
}

/// log2(1843/2048) = -0.15216 = -1246.5 times 2^-13, a little above, so -1246 times; times 32 exactly -4.8671875;
/// exp2 of that is 0.034263 = 1122.7 times 2^-15.
TEST(HalfNumbers, PowIsExp2OfLog2) {
    EXPECT_EQ(half(0.9).value, 1843.0 / 2048);
    EXPECT_EQ(pow(half(0.9), half(32)).value, 1123.0 / 32768);
    EXPECT_EQ(pow(half(0), half(32)).value, 0);
    EXPECT_TRUE(std::isnan(pow(half(1), half(1e5)).value)) << "infinity times log2(1): the black highlight";
}

} // namespace
} // namespace sandbox::reference

#include "measure/metrics/metrics.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <stdexcept>

namespace sandbox {
namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

/// A 4 x 2 grey picture; object 1 everywhere but in the first pixel, which is background.
Frame grey(float value = 0.5F) {
    Frame frame;
    frame.color = Image({4, 2}, glm::vec4(value, value, value, 1));
    frame.object_ids.assign(8, 1);
    frame.object_ids[0] = 0;
    return frame;
}

ReferenceFrame truth(double value = 0.5) {
    ReferenceFrame frame;
    frame.size = {4, 2};
    frame.color.assign(8, glm::dvec3(value));
    frame.object_ids.assign(8, 1);
    frame.object_ids[0] = 0;
    frame.edge.assign(8, 0);
    frame.rival.assign(8, 0);
    frame.jump.assign(8, 0);
    frame.rounding.assign(8, 0);
    return frame;
}

TEST(Metrics, IdenticalPicturesHaveNoErrorAndNoPsnr) {
    const Metrics m = compare(grey(), truth());
    EXPECT_EQ(m.compared_pixels, 7U);
    EXPECT_EQ(m.norms.rmse, 0);
    EXPECT_EQ(m.norms.max_abs, 0);
    EXPECT_EQ(m.norms.p99_abs, 0);
    EXPECT_FALSE(m.psnr.has_value());
    EXPECT_EQ(m.max_levels, 0);
    EXPECT_EQ(m.differing_share, 0);
    EXPECT_EQ(m.flip, 0);
    EXPECT_EQ(m.nonfinite_pixels + m.silhouette_pixels + m.edge_pixels + m.jump_pixels, 0U);
}

TEST(Metrics, OneChannelOfOnePixel) {
    Frame left = grey();
    left.color.pixels[3].g = 0.75F;
    const Metrics m = compare(left, truth());
    EXPECT_DOUBLE_EQ(m.norms.max_abs, 0.25);
    EXPECT_EQ(m.worst_pixel, 3U);
    EXPECT_DOUBLE_EQ(m.norms.mean_abs, 0.25 / 21);
    EXPECT_DOUBLE_EQ(m.norms.rmse, 0.25 / std::sqrt(21.0));
    EXPECT_DOUBLE_EQ(m.norms.p99_abs, 0.25); // 99 % of 21 is 20.8: the 21st of 21
    EXPECT_DOUBLE_EQ(*m.psnr, -20 * std::log10(0.25 / std::sqrt(21.0)));
    EXPECT_EQ(m.max_levels, 63); // round(127.5) = 128, round(191.25) = 191
    EXPECT_DOUBLE_EQ(m.differing_share, 1.0 / 7);
    EXPECT_GT(m.flip, 0);
}

TEST(Metrics, DifferencesFarBelowFloat32AreSeen) {
    EXPECT_NEAR(compare(grey(), truth(0.5 + 1e-9)).norms.rmse, 1e-9, 1e-15);
}

TEST(Metrics, BackgroundIsNotCompared) {
    Frame left = grey();
    left.color.pixels[0].r = 9;
    const Metrics m = compare(left, truth());
    EXPECT_EQ(m.norms.max_abs, 0);
    EXPECT_EQ(m.compared_pixels, 7U);
}

TEST(Metrics, SilhouettesEdgesAndJumpsAreCountedApart) {
    Frame left = grey();
    ReferenceFrame right = truth();
    for (glm::vec4 &pixel : left.color.pixels) {
        pixel.r += 0.25F;
    }
    left.object_ids[0] = 1; // background in the truth
    left.object_ids[1] = 2;
    left.object_ids[2] = 0;
    right.edge = {1, 1, 0, 1, 1, 0, 0, 0};
    right.jump = {0, 0, 0, 1, 0, 1, 0, 0};
    const Metrics m = compare(left, right);
    EXPECT_EQ(m.silhouette_pixels, 3U);
    EXPECT_EQ(m.edge_pixels, 2U);
    EXPECT_EQ(m.jump_pixels, 1U);
    EXPECT_EQ(m.compared_pixels, 2U);
    EXPECT_DOUBLE_EQ(m.norms.mean_abs, 0.25 / 3);
}

TEST(Metrics, AMaskedPixelCountsOnceUnderTheFirstCause) {
    Frame left = grey();
    ReferenceFrame right = truth();
    for (std::size_t i = 0; i < 8; ++i) {
        left.color.pixels[i].g += static_cast<float>(i) / 16; // exact in float32
    }
    left.object_ids[1] = 2;
    right.edge = {1, 1, 1, 0, 0, 0, 0, 0}; // of background in both pictures, too
    right.jump = {1, 1, 1, 1, 0, 0, 0, 0};
    right.rounding = {1, 1, 1, 1, 1, 1, 0, 0};
    const Metrics m = compare(left, right);
    EXPECT_EQ(m.silhouette_pixels, 1U);
    EXPECT_EQ(m.edge_pixels, 1U);
    EXPECT_EQ(m.jump_pixels, 1U);
    EXPECT_EQ(m.rounding_pixels, 2U);
    EXPECT_EQ(m.compared_pixels, 2U);
    EXPECT_DOUBLE_EQ(m.compared_share, 2.0 / 7) << "background never counts";
    EXPECT_DOUBLE_EQ(m.silhouette_max_abs, 1.0 / 16);
    EXPECT_DOUBLE_EQ(m.edge_max_abs, 2.0 / 16);
    EXPECT_DOUBLE_EQ(m.jump_max_abs, 3.0 / 16);
    EXPECT_DOUBLE_EQ(m.rounding_max_abs, 5.0 / 16);
    EXPECT_DOUBLE_EQ(m.norms.max_abs, 7.0 / 16);
    const std::vector<PixelUse> uses = pixel_uses(left.object_ids, right);
    EXPECT_EQ(uses,
              (std::vector<PixelUse>{PixelUse::background, PixelUse::silhouette, PixelUse::edge, PixelUse::jump,
                                     PixelUse::rounding, PixelUse::rounding, PixelUse::compared, PixelUse::compared}));
    const ByteImage picture = mask_picture(to_display(left.color, Display::linear), uses);
    EXPECT_EQ(picture.rgb[3 * 4], masks[3].color[0]);
    EXPECT_EQ(picture.rgb[3 * 4 + 1], masks[3].color[1]);
    EXPECT_EQ(picture.rgb[3 * 7], picture.rgb[3 * 7 + 1]) << "what is compared is grey";
    EXPECT_NE(why_untrusted(m).find("2 of the 7"), std::string::npos) << why_untrusted(m);
    right.edge.assign(8, 0);
    right.jump.assign(8, 0);
    right.rounding.assign(8, 0);
    const Metrics most = compare(left, right);
    EXPECT_TRUE(std::isnan(most.edge_max_abs)) << "an empty mask hides no error";
    EXPECT_TRUE(why_untrusted(most).empty());
    right.rounding = {0, 0, 0, 0, 1, 1, 1, 0};
    EXPECT_DOUBLE_EQ(compare(left, right).compared_share, 3.0 / 7);
    EXPECT_FALSE(why_untrusted(compare(left, right)).empty());
}

TEST(Metrics, WhatIsNotFiniteIsNotHiddenByAMask) {
    Frame left = grey();
    left.color.pixels[3].r = not_a_number;
    ReferenceFrame right = truth();
    right.edge[3] = 1;
    const Metrics m = compare(left, right);
    EXPECT_EQ(m.nonfinite_pixels, 1U);
    EXPECT_TRUE(std::isinf(m.norms.max_abs));
    EXPECT_TRUE(std::isinf(m.edge_max_abs));
}

TEST(Metrics, NonFinitePixelsFailEveryNorm) {
    for (const std::size_t pixel : {0U, 3U}) { // in the background too
        Frame left = grey();
        left.color.pixels[pixel].b = pixel == 0 ? std::numeric_limits<float>::infinity() : not_a_number;
        const Metrics m = compare(left, truth());
        EXPECT_EQ(m.nonfinite_pixels, 1U);
        EXPECT_EQ(m.worst_pixel, pixel);
        EXPECT_EQ(m.compared_pixels, 7U);
        EXPECT_TRUE(std::isinf(m.norms.rmse) && std::isinf(m.norms.mean_abs));
        EXPECT_TRUE(m.norms.max_abs > 1e300 && m.norms.p99_abs > 1e300);
        EXPECT_TRUE(m.psnr.has_value() && std::isinf(*m.psnr) && *m.psnr < 0);
        EXPECT_GT(m.flip, 0);
    }
    ReferenceFrame right = truth();
    right.color[5].x = std::nan("");
    EXPECT_EQ(compare(grey(), right).nonfinite_pixels, 1U);
}

TEST(Metrics, NinetyNinthPercentileIsARank) {
    // 100 x 1 pixels, 300 channels: the 297th smallest. Three channels of one pixel differ more.
    Frame left;
    left.color = Image({100, 1});
    left.object_ids.assign(100, 1);
    Frame right = left;
    for (std::size_t i = 0; i < 100; ++i) {
        left.color.pixels[i].g = static_cast<float>(i) / 128;
    }
    left.color.pixels[99] = {2, 2, 2, 1};
    EXPECT_DOUBLE_EQ(compare(left, right).norms.p99_abs, 98.0 / 128);
    EXPECT_DOUBLE_EQ(compare(left, right).norms.max_abs, 2);
}

TEST(Metrics, DrawnPicturesAndTruthsCompareToo) {
    EXPECT_NEAR(compare(grey(0.25F), grey(0.75F)).norms.rmse, 0.5, 1e-15);
    ReferenceFrame left = truth();
    left.jump[4] = 1;
    EXPECT_EQ(compare(left, truth()).jump_pixels, 1U);
}

TEST(Metrics, WhatCannotBeComparedIsRefused) {
    Frame other = grey();
    other.color = Image({2, 4});
    EXPECT_THROW(compare(other, truth()), std::invalid_argument);
    Frame without = grey();
    without.object_ids.clear();
    EXPECT_THROW(compare(without, truth()), std::invalid_argument);
}

/// No error is no success where nothing was compared.
TEST(Metrics, ARivalIsNoReasonToLeaveOutWhatIsSeen) {
    Frame left = grey();
    ReferenceFrame right = truth();
    right.edge.assign(8, 1);
    right.rival = {1, 1, 1, 1, 0, 0, 0, 0};
    left.object_ids[2] = 2; // the rival is seen
    left.color.pixels[3].g += 0.25F;
    const Metrics m = compare(left, right);
    EXPECT_EQ(m.silhouette_pixels, 1U);
    EXPECT_EQ(m.compared_pixels, 2U);
    EXPECT_EQ(m.edge_pixels, 4U);
    EXPECT_DOUBLE_EQ(m.norms.max_abs, 0.25);
}

TEST(Metrics, NothingToCompareHasNoNumbers) {
    const auto expect_none = [](const Metrics &m) {
        EXPECT_EQ(m.compared_pixels, 0U);
        EXPECT_TRUE(std::isnan(m.norms.rmse) && std::isnan(m.norms.mean_abs));
        EXPECT_TRUE(std::isnan(m.norms.max_abs) && std::isnan(m.norms.p99_abs));
        EXPECT_TRUE(std::isnan(m.differing_share));
        EXPECT_FALSE(m.max_levels.has_value());
        EXPECT_TRUE(m.psnr.has_value() && std::isnan(*m.psnr)) << "not infinite, as of identical pictures";
        EXPECT_FALSE(m.norms.max_abs <= 1e9) << "no bound is met";
    };
    Frame left = grey();
    ReferenceFrame right = truth();
    right.edge.assign(8, 1);
    const Metrics masked = compare(left, right);
    expect_none(masked);
    EXPECT_EQ(masked.compared_share, 0);
    EXPECT_EQ(masked.edge_max_abs, 0);
    EXPECT_EQ(why_untrusted(masked), "none of the 7 pixels that show an object are compared; left out: edge 7");
    left.object_ids.assign(8, 0);
    right.object_ids.assign(8, 0);
    const Metrics background = compare(left, right);
    expect_none(background);
    EXPECT_TRUE(std::isnan(background.compared_share)) << "0 / 0";
    EXPECT_EQ(why_untrusted(background), "neither picture shows an object");
}

TEST(Metrics, EveryRowReadsItsOwnMember) {
    Metrics m;
    m.norms = {1, 2, 3, 4};
    m.psnr = 5;
    m.flip = 6;
    m.max_levels = 7;
    m.differing_share = 8;
    m.compared_pixels = 9;
    m.compared_share = 10;
    m.silhouette_pixels = 11;
    m.edge_pixels = 12;
    m.jump_pixels = 13;
    m.rounding_pixels = 14;
    m.silhouette_max_abs = 15;
    m.edge_max_abs = 16;
    m.jump_max_abs = 17;
    m.rounding_max_abs = 18;
    m.nonfinite_pixels = 19;
    double expected = 0;
    for_each_metric(m, [&](const auto &metric, const auto &measured) {
        EXPECT_EQ(metric.value(measured), ++expected) << metric.name;
    });
    m.psnr.reset();
    EXPECT_FALSE(metric_quantities[0].value(m)) << "identical pictures have no psnr";
}

TEST(ErrorSplit, EachCauseInItsOwnColumn) {
    const Frame drawn = grey(0.625F);
    const ReferenceFrame technique = truth(0.5);
    const ReferenceFrame per_pixel = truth(0.25);
    const ReferenceFrame analytic = truth(0.125);
    const ErrorSplit split = split_error(drawn, technique, per_pixel, &analytic);
    EXPECT_DOUBLE_EQ(split.arithmetic.rmse, 0.125);
    EXPECT_DOUBLE_EQ(split.interpolation.rmse, 0.25);
    EXPECT_DOUBLE_EQ(split.geometry->rmse, 0.125);
    EXPECT_NEAR(split.quantisation.max_abs, std::abs(159.0 / 255 - 0.625), 1e-15); // 0.625 * 255 = 159.4
    EXPECT_FALSE(split_error(drawn, technique, per_pixel, nullptr).geometry.has_value());
}

TEST(ErrorSplit, QuantisationIsAtMostHalfALevelAlsoAboveOne) {
    Frame drawn = grey();
    for (std::size_t i = 0; i < 8; ++i) {
        drawn.color.pixels[i] = glm::vec4(static_cast<float>(i) * 0.2371F);
    }
    const ErrorSplit split = split_error(drawn, truth(), truth(), nullptr);
    EXPECT_LE(split.quantisation.max_abs, 1.0 / 510);
    EXPECT_GT(split.quantisation.max_abs, 0);
    drawn.color.pixels[2].r = not_a_number;
    EXPECT_TRUE(std::isinf(split_error(drawn, truth(), truth(), nullptr).quantisation.rmse));
}

} // namespace
} // namespace sandbox

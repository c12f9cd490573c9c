#include "capture/masks.h"

#include "capture/picture.h"
#include "image/cut_paste.h"
#include "tools/english.h"
#include "tools/pixel.h"

#include <gtest/gtest.h>

namespace sandbox {
namespace {

using Rgb = PixelRgb;

TEST(Masks, TheLegendNamesEveryMaskWithItsColour) {
    Metrics metrics;
    metrics.compared_share = 0.875;
    metrics.edge_pixels = 12;
    metrics.edge_max_abs = 0.25;
    const auto legend = mask_legend(english, metrics);
    ASSERT_EQ(legend.size(), 1 + std::size(masks));
    EXPECT_EQ(legend[0].text, "against its reference: 87.5 % compared");
    EXPECT_FALSE(legend[0].color);
    EXPECT_EQ(legend[1].text, "silhouette: none");
    EXPECT_EQ(legend[2].text, "edge: 12 pixels, error up to 0.25");
    EXPECT_EQ(legend[2].color, masks[1].color);
    EXPECT_EQ(mask_legend(english, Metrics{})[0].text, "against its reference: nothing is shown");
}

/// It stays within its columns, in the lower corner that is asked for, and is left out where it could not be read.
TEST(Masks, TheLegendStaysInItsCorner) {
    for (const bool right : {false, true}) {
        ByteImage picture = black_picture({640, 200});
        draw_mask_legend(picture, english, Metrics{}, 200, 500, 180, 12, right);
        const Rgb black{0, 0, 0};
        EXPECT_NE(pixel(picture, right ? 499 : 200, 179), black);
        EXPECT_EQ(pixel(picture, right ? 200 : 499, 179), black);
        EXPECT_EQ(pixel(picture, 199, 179), black);
        EXPECT_EQ(pixel(picture, 500, 179), black);
        EXPECT_EQ(pixel(picture, right ? 499 : 200, 180), black);
    }
    ByteImage small = black_picture({40, 30});
    draw_mask_legend(small, english, Metrics{}, 0, 40, 30, 12, false);
    EXPECT_EQ(small.rgb, black_picture({40, 30}).rgb);
}

Image plain(const Scene &, const Technique &, Size size) { return Image(size, glm::vec4(0.4F, 0.8F, 0.2F, 1)); }

/// Of A the left column is masked as an edge; of B the top row as a jump.
JudgedView judged(const Scene &, const Technique &technique, const Technique &, Size size, bool) {
    JudgedView view;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            view.uses.push_back(technique.model == Model::phong ? x == 0 ? PixelUse::edge : PixelUse::compared
                                : y == 0                        ? PixelUse::jump
                                                                : PixelUse::compared);
        }
    }
    return view;
}

PictureOptions with_masks(Layout layout, Size size) {
    PictureOptions options;
    options.layout = layout;
    options.left = parse_technique("per-pixel/phong");
    options.right = parse_technique("per-pixel/lambert");
    options.size = size;
    options.masks = true;
    return options;
}

ByteImage shown(const PictureOptions &options) {
    return show_picture({}, options, {.draw = plain, .textbook = plain, .truth = plain, .judge = judged});
}

constexpr Rgb edge{255, 230, 50}, jump{255, 110, 30}, grey{59, 59, 59}; // (102 + 204 + 51) / 6, cut
constexpr Rgb color{102, 204, 51};

TEST(Masks, EachViewIsGreyUnderItsOwnMasksAndTheTruthKeepsItsColours) {
    const ByteImage picture = shown(with_masks(Layout::three_up, {9, 4}));
    EXPECT_EQ(pixel(picture, 0, 2), edge);
    EXPECT_EQ(pixel(picture, 1, 0), grey);
    EXPECT_EQ(pixel(picture, 3, 0), jump);
    EXPECT_EQ(pixel(picture, 3, 2), grey);
    EXPECT_EQ(pixel(picture, 6, 0), color);
}

TEST(Masks, AWipeShowsEachSidesMasksOnItsSide) {
    PictureOptions options = with_masks(Layout::wipe, {8, 4});
    options.divider = 1;
    EXPECT_EQ(pixel(shown(options), 0, 0), edge);
    EXPECT_EQ(pixel(shown(options), 6, 0), grey) << "the last column is the divider's";
    options.divider = 0;
    EXPECT_EQ(pixel(shown(options), 7, 0), jump);
    EXPECT_EQ(pixel(shown(options), 7, 2), grey);
}

TEST(Masks, AFlipJudgesTheSideThatItShowsAndADifferenceNone) {
    PictureOptions options = with_masks(Layout::single, {4, 4});
    options.flip = FlipSide::b;
    EXPECT_EQ(pixel(shown(options), 0, 0), jump);
    options.flip = FlipSide::a;
    EXPECT_EQ(pixel(shown(options), 0, 0), edge);
    options = with_masks(Layout::difference, {4, 4});
    const ByteImage masked = shown(options);
    options.masks = false;
    EXPECT_EQ(masked.rgb, shown(options).rgb);
}

/// Masks are of pixels, so one sample is drawn.
TEST(Masks, HaveOneSampleAPixel) {
    int drawn = 0;
    PictureOptions options = with_masks(Layout::single, {4, 4});
    options.samples = 16;
    const auto counted = [&](const Scene &s, const Technique &t, Size size) {
        ++drawn;
        return plain(s, t, size);
    };
    show_picture({}, options, {.draw = counted, .textbook = {}, .truth = {}, .judge = judged});
    EXPECT_EQ(drawn, 1);
}

} // namespace
} // namespace sandbox

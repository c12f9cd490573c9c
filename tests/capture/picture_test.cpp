#include "capture/picture.h"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <limits>

namespace sandbox {
namespace {

using Rgb = std::array<int, 3>;

Rgb pixel(const ByteImage &image, int x, int y) {
    const std::size_t at =
        3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.size.width) + static_cast<std::size_t>(x));
    return {image.rgb[at], image.rgb[at + 1], image.rgb[at + 2]};
}

/// Stands in for a renderer: one colour a model.
Image fake(const Scene &, const Technique &technique, Size size) {
    return Image(size,
                 technique.model == Model::phong ? glm::vec4(0.2f, 0.4f, 0.6f, 1) : glm::vec4(0.4f, 0.2f, 0.6f, 1));
}

PictureOptions two_views(Layout layout, Size size) {
    PictureOptions options;
    options.layout = layout;
    options.left = parse_technique("per-pixel/phong");
    options.right = parse_technique("per-pixel/lambert");
    options.size = size;
    return options;
}

ByteImage shown(const PictureOptions &options) {
    return show_picture(draw_picture({}, options, {fake, {}, {}}), options);
}

// 0.2, 0.4, 0.6 times 255, rounded.
constexpr Rgb left_color{51, 102, 153};
constexpr Rgb right_color{102, 51, 153};

TEST(Picture, SideBySide) {
    const ByteImage picture = shown(two_views(Layout::side_by_side, {5, 2}));
    EXPECT_EQ(picture.size, (Size{5, 2}));
    EXPECT_EQ(pixel(picture, 2, 1), left_color);
    EXPECT_EQ(pixel(picture, 3, 1), right_color);
}

TEST(Picture, ViewsAreDrawnAtTheirOwnSize) {
    std::vector<Size> sizes;
    const auto spy = [&](const Scene &s, const Technique &t, Size size) {
        sizes.push_back(size);
        return fake(s, t, size);
    };
    draw_picture({}, two_views(Layout::side_by_side, {9, 4}), {spy, {}, {}});
    draw_picture({}, two_views(Layout::wipe, {9, 4}), {spy, {}, {}});
    EXPECT_EQ(sizes, (std::vector<Size>{{5, 4}, {4, 4}, {9, 4}, {9, 4}}));
}

TEST(Picture, ASingleViewIsDrawnOnce) {
    int drawn = 0;
    PictureOptions options;
    const auto count = [&](const Scene &s, const Technique &t, Size size) {
        ++drawn;
        return fake(s, t, size);
    };
    draw_picture({}, options, {count, {}, {}});
    EXPECT_EQ(drawn, 1);
}

TEST(Picture, AThreeUpsLastViewIsTheTruthOfTheLeftOne) {
    PictureOptions options = two_views(Layout::three_up, {7, 2});
    options.left = parse_technique("per-vertex/phong:gate=none");
    std::string asked;
    const auto truth = [&](const Scene &, const Technique &t, Size size) {
        asked = to_string(t);
        return Image(size, glm::vec4(1));
    };
    const ByteImage picture = show_picture(draw_picture({}, options, {fake, {}, truth}), options);
    EXPECT_EQ(asked, "per-pixel/phong");
    EXPECT_EQ(pixel(picture, 4, 0), right_color);
    EXPECT_EQ(pixel(picture, 5, 0), (Rgb{255, 255, 255}));
}

TEST(Picture, LabelledViewsAreDividedWhereTheSecondBegins) {
    PictureOptions options = two_views(Layout::side_by_side, {201, 40});
    const ByteImage plain = shown(options);
    EXPECT_EQ(pixel(plain, 100, 39), left_color) << "the left one has the odd column";
    EXPECT_EQ(pixel(plain, 101, 39), right_color);
    options.labels = true;
    EXPECT_EQ(pixel(shown(options), 100, 39), (Rgb{255, 255, 255}));
}

TEST(Picture, ATextbooksLeftViewIsDrawnByIt) {
    PictureOptions options = two_views(Layout::side_by_side, {4, 2});
    options.textbook_left = true;
    const auto white = [](const Scene &, const Technique &, Size size) { return Image(size, glm::vec4(1)); };
    const ByteImage picture = show_picture(draw_picture({}, options, {fake, white, {}}), options);
    EXPECT_EQ(pixel(picture, 1, 0), (Rgb{255, 255, 255}));
    EXPECT_EQ(pixel(picture, 2, 0), right_color);
    EXPECT_EQ(textbook_name(options.left), "textbook float32/phong");
}

TEST(Picture, AWipeHasADividerAndItsDataHasNone) {
    const PictureOptions options = two_views(Layout::wipe, {8, 2});
    const Image data = draw_picture({}, options, {fake, {}, {}});
    EXPECT_EQ(data.at(3, 0), glm::vec4(0.2f, 0.4f, 0.6f, 1));
    EXPECT_EQ(data.at(4, 0), glm::vec4(0.4f, 0.2f, 0.6f, 1));
    const ByteImage picture = show_picture(data, options);
    EXPECT_EQ(pixel(picture, 2, 0), left_color);
    EXPECT_EQ(pixel(picture, 3, 0), (Rgb{255, 255, 255}));
    EXPECT_EQ(pixel(picture, 4, 0), right_color);
}

TEST(Picture, AWipeIsDividedWhereItIsAskedFor) {
    PictureOptions options = two_views(Layout::wipe, {10, 2});
    options.divider = 0.28;
    const ByteImage picture = shown(options);
    EXPECT_EQ(pixel(picture, 1, 0), left_color);
    EXPECT_EQ(pixel(picture, 2, 0), (Rgb{255, 255, 255}));
    EXPECT_EQ(pixel(picture, 3, 0), right_color);
    options.divider = 0;
    EXPECT_EQ(pixel(shown(options), 1, 0), right_color);
    options.divider = 1;
    EXPECT_EQ(pixel(shown(options), 8, 0), left_color);
}

TEST(Picture, LabelsOfAWipeStandOverTheirViews) {
    PictureOptions options = two_views(Layout::wipe, {600, 120});
    options.labels = true;
    options.divider = 0.9; // the right label is cut off in a tenth of the width
    const ByteImage late = shown(options);
    options.divider = 0.5;
    const ByteImage middle = shown(options);
    const auto bright = [](const ByteImage &image, int from, int to) {
        int count = 0;
        for (int y = 0; y < 12; ++y) {
            for (int x = from; x < to; ++x) {
                count += pixel(image, x, y)[0] > 200 ? 1 : 0;
            }
        }
        return count;
    };
    EXPECT_GT(bright(middle, 305, 500), 20);
    EXPECT_EQ(bright(late, 305, 500), 0);
}

TEST(Picture, ADifferenceIsSignedAsDataAndMagnifiedAsPicture) {
    PictureOptions options = two_views(Layout::difference, {2, 2});
    options.gain = 2;
    const Image data = draw_picture({}, options, {fake, {}, {}});
    EXPECT_EQ(data.at(1, 1), glm::vec4(0.2f - 0.4f, 0.4f - 0.2f, 0, 1)) << "gain belongs to the picture";
    EXPECT_EQ(pixel(show_picture(data, options), 1, 1), (Rgb{102, 102, 0}));
    options.exposure = 0.5;
    EXPECT_EQ(pixel(show_picture(data, options), 1, 1), (Rgb{51, 51, 0}));
}

TEST(Picture, ANonFiniteDifferenceIsNotHidden) {
    PictureOptions options = two_views(Layout::difference, {1, 1});
    const auto broken = [](const Scene &, const Technique &, Size size) {
        return Image(size, glm::vec4(std::numeric_limits<float>::infinity()));
    };
    const Image data = draw_picture({}, options, {broken, {}, {}});
    EXPECT_EQ(pixel(show_picture(data, options), 0, 0), (Rgb{255, 0, 255})) << "magenta";
}

TEST(Picture, ExposureAndCurveReachThePicture) {
    PictureOptions options = two_views(Layout::single, {1, 1});
    options.exposure = 2;
    EXPECT_EQ(pixel(shown(options), 0, 0), (Rgb{102, 204, 255}));
    options.exposure = 1;
    options.display = Display::srgb;
    // 1.055 * 0.2^(1/2.4) - 0.055 = 0.4845 -> 123.5 -> 124; 0.4 -> 0.6652 -> 170; 0.6 -> 0.7977 -> 203.
    EXPECT_EQ(pixel(shown(options), 0, 0), (Rgb{124, 170, 203}));
}

TEST(Picture, LabelsDarkenAStripAndWriteInIt) {
    PictureOptions options = two_views(Layout::side_by_side, {640, 360});
    const ByteImage plain = shown(options);
    options.labels = true;
    const ByteImage labelled = shown(options);
    // A 26th of the height a line and a half of it: 20 rows.
    EXPECT_EQ(pixel(labelled, 639, 0), (Rgb{36, 18, 54})) << "0.35 of the colour";
    EXPECT_EQ(pixel(labelled, 0, 100), pixel(plain, 0, 100));
    const auto white_in = [&](int from, int to) {
        int white = 0;
        for (int y = 0; y < 20; ++y) {
            for (int x = from; x < to; ++x) {
                white += pixel(labelled, x, y) == Rgb{255, 255, 255} ? 1 : 0;
            }
        }
        return white;
    };
    EXPECT_GT(white_in(0, 320), 50);
    EXPECT_GT(white_in(320, 640), 50);
}

TEST(Picture, LabelsFitAnySize) {
    for (const Layout layout : {Layout::single, Layout::side_by_side, Layout::wipe, Layout::difference}) {
        for (const Size size : {Size{2, 1}, Size{2, 300}, Size{40, 30}, Size{3000, 8}}) {
            PictureOptions options = two_views(layout, size);
            options.labels = true;
            EXPECT_EQ(shown(options).size, size);
        }
    }
}

} // namespace
} // namespace sandbox

#include "capture/picture.h"

#include "tools/english.h"
#include "tools/pixel.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <gtest/gtest.h>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace sandbox {
namespace {

using Rgb = PixelRgb;

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

ByteImage shown(const PictureOptions &options) { return show_picture({}, options, {fake, {}, fake}); }

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
    const ByteImage picture = show_picture({}, options, {fake, {}, truth});
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
    const ByteImage picture = show_picture({}, options, {fake, white, {}});
    EXPECT_EQ(pixel(picture, 1, 0), (Rgb{255, 255, 255}));
    EXPECT_EQ(pixel(picture, 2, 0), right_color);
    EXPECT_EQ(textbook_name(options.left), "textbook float32/phong");
    EXPECT_EQ(mesh_factor_note(english, 1), "");
    EXPECT_EQ(mesh_factor_note(english, 0.5), ", mesh x 1/2");
}

TEST(Picture, AWipeHasADividerAndItsDataHasNone) {
    const PictureOptions options = two_views(Layout::wipe, {8, 2});
    const Image data = draw_picture({}, options, {fake, {}, {}});
    EXPECT_EQ(data.at(3, 0), glm::vec4(0.2f, 0.4f, 0.6f, 1));
    EXPECT_EQ(data.at(4, 0), glm::vec4(0.4f, 0.2f, 0.6f, 1));
    const ByteImage picture = shown(options);
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

TEST(Picture, LabelsOfAWipeStandOverTheirViewsAndAreWhole) {
    PictureOptions options = two_views(Layout::wipe, {600, 120});
    options.labels = true;
    options.divider = 0.9; // a tenth of the width is too narrow for the right label, which then begins before it
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
    EXPECT_GT(bright(middle, 305, 450), 20);
    EXPECT_EQ(bright(late, 305, 450), 0);
    EXPECT_EQ(bright(late, 450, 600), bright(middle, 305, 450)) << "the same text, whole, in the same size";
}

/// The window's colours: 1 - t + t (0.13, 0.35, 0.75) where the second picture is brighter.
TEST(Picture, ADifferenceIsSignedAsDataAndAsPicture) {
    PictureOptions options = two_views(Layout::difference, {2, 2});
    options.gain = 2.5; // red and green differ alike, by 0.2: t = 0.5
    const Image data = draw_picture({}, options, {fake, {}, {}});
    EXPECT_EQ(data.at(1, 1), glm::vec4(0.2f - 0.4f, 0.4f - 0.2f, 0, 1)) << "gain belongs to the picture";
    EXPECT_EQ(pixel(shown(options), 1, 1), (Rgb{144, 172, 223}));
    options.exposure = 0.5;
    options.display = Display::srgb;
    EXPECT_EQ(pixel(shown(options), 1, 1), (Rgb{144, 172, 223})) << "the colours stand for numbers, not for light";
    std::swap(options.left, options.right);
    EXPECT_EQ(pixel(shown(options), 1, 1), (Rgb{236, 175, 129})) << "orange: (0.85, 0.37, 0.01)";
}

TEST(Picture, ADifferenceMayBeOfASideAndItsTruth) {
    PictureOptions options = two_views(Layout::difference, {2, 2});
    std::vector<std::string> drawn;
    const auto spy = [&](const std::string &who) {
        return [&drawn, who](const Scene &s, const Technique &t, Size size) {
            drawn.push_back(who + to_string(t));
            return fake(s, t, size);
        };
    };
    const Painters painters{spy(""), {}, spy("truth ")};
    options.left = parse_technique("per-vertex/phong:gate=none");
    options.difference_of = DifferenceOf::a_truth;
    EXPECT_EQ(draw_picture({}, options, painters).at(0, 0), glm::vec4(0, 0, 0, 1));
    options.difference_of = DifferenceOf::b_truth;
    draw_picture({}, options, painters);
    EXPECT_EQ(drawn, (std::vector<std::string>{"per-vertex/phong:gate=none", "truth per-pixel/phong",
                                               "per-pixel/lambert", "truth per-pixel/lambert"}));
}

TEST(Picture, ADifferenceHasItsScaleBelowAndTheFileKeepsItsSize) {
    PictureOptions options = two_views(Layout::difference, {600, 300});
    const ByteImage picture = shown(options);
    EXPECT_EQ(picture.size, options.size);
    const int rows = room_for_views(options).height;
    EXPECT_EQ(rows, 263) << "text of a 52nd of the width, 3.2 times that";
    EXPECT_EQ(pixel(picture, 300, rows - 1), (Rgb{211, 222, 242})) << "t = 0.2";
    std::set<Rgb> bar;
    for (int x = 0; x < 600; ++x) {
        bar.insert(pixel(picture, x, rows + 10));
    }
    // The middles of the first, the middle and the last of 300 columns: within a level of the palette's ends.
    const auto holds = [&](Rgb color) {
        return std::ranges::any_of(bar, [&](const Rgb &c) {
            return std::abs(c[0] - color[0]) <= 1 && std::abs(c[1] - color[1]) <= 1 && std::abs(c[2] - color[2]) <= 1;
        });
    };
    EXPECT_TRUE(holds({33, 89, 191}));
    EXPECT_TRUE(holds({217, 94, 3}));
    EXPECT_TRUE(holds({255, 255, 255}));
}

TEST(Picture, AFlipShowsOneOfTwo) {
    PictureOptions options = two_views(Layout::single, {2, 2});
    options.flip = FlipSide::a;
    EXPECT_EQ(pixel(shown(options), 0, 0), left_color);
    options.flip = FlipSide::b;
    EXPECT_EQ(pixel(shown(options), 0, 0), right_color);
}

TEST(Picture, AFileGrowsByItsStripsAroundTheViewsOfAWindow) {
    for (const Layout layout :
         {Layout::single, Layout::side_by_side, Layout::wipe, Layout::difference, Layout::three_up}) {
        for (const Size room : {Size{3, 1}, Size{302, 200}, Size{960, 541}, Size{1919, 1080}, Size{3000, 30}}) {
            PictureOptions options = two_views(layout, {});
            options.labels = true;
            options.left =
                parse_technique("per-vertex/phong:normals=untransformed,gate=none,direction=unnegated-diffuse");
            options.size = size_around(options, room);
            EXPECT_EQ(room_for_views(options), room);
            EXPECT_EQ(options.size.width, room.width);
        }
    }
}

TEST(Picture, ANonFiniteDifferenceIsNotHidden) {
    PictureOptions options = two_views(Layout::difference, {1, 1});
    const auto broken = [](const Scene &, const Technique &, Size size) {
        return Image(size, glm::vec4(std::numeric_limits<float>::infinity()));
    };
    EXPECT_EQ(pixel(show_picture({}, options, {broken, {}, {}}), 0, 0), (Rgb{255, 0, 255})) << "magenta";
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

TEST(Picture, LabelsStandInAStripAboveTheViews) {
    PictureOptions options = two_views(Layout::side_by_side, {640, 360});
    const ByteImage plain = shown(options);
    options.labels = true;
    const ByteImage labelled = shown(options);
    // Text of a 50th of the width, a line and a half of it: 20 rows.
    EXPECT_EQ(room_for_views(options), (Size{640, 340}));
    EXPECT_EQ(pixel(labelled, 639, 0), (Rgb{24, 26, 30}));
    EXPECT_EQ(pixel(labelled, 0, 20), pixel(plain, 0, 0)) << "nothing covers the picture";
    EXPECT_EQ(pixel(labelled, 639, 20), pixel(plain, 639, 0));
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
    for (const Layout layout :
         {Layout::single, Layout::side_by_side, Layout::wipe, Layout::difference, Layout::three_up}) {
        for (const Size size : {Size{3, 1}, Size{3, 300}, Size{40, 30}, Size{3000, 8}}) {
            PictureOptions options = two_views(layout, size);
            options.labels = true;
            EXPECT_EQ(shown(options).size, size);
        }
    }
}

} // namespace
} // namespace sandbox

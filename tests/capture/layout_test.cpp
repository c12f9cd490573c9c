#include "capture/layout.h"

#include "image/error.h"

#include <gtest/gtest.h>

namespace sandbox {
namespace {

const glm::vec4 red(1, 0.25f, 0, 1);
const glm::vec4 blue(0, 0.5f, 1, 1);

Image composed(Layout layout, Size picture) {
    const std::vector<Size> sizes = view_sizes(layout, picture);
    return compose(layout, std::vector{Image(sizes.front(), red), Image(sizes.back(), blue)});
}

/// The first column from which on row `y` is blue; all before must be red.
int first_blue_column(const Image &image, int y) {
    int x = 0;
    while (x < image.size.width && image.at(x, y) == red) {
        ++x;
    }
    for (int rest = x; rest < image.size.width; ++rest) {
        EXPECT_EQ(image.at(rest, y), blue) << rest << ", " << y;
    }
    return x;
}

TEST(Layout, SideBySideSharesTheWidth) {
    for (const int width : {2, 3, 6, 7}) {
        const Image picture = composed(Layout::side_by_side, {width, 3});
        EXPECT_EQ(picture.size, (Size{width, 3}));
        for (int y = 0; y < 3; ++y) {
            EXPECT_EQ(first_blue_column(picture, y), (width + 1) / 2) << "the left view has the odd column";
        }
    }
}

TEST(Layout, SideBySideKeepsEachViewWhole) {
    Image left({2, 2}, red), right({2, 2}, blue);
    left.at(1, 1) = glm::vec4(7);
    right.at(0, 1) = glm::vec4(8);
    const Image picture = compose(Layout::side_by_side, std::vector{left, right});
    EXPECT_EQ(picture.at(1, 1), glm::vec4(7));
    EXPECT_EQ(picture.at(2, 1), glm::vec4(8));
    EXPECT_EQ(picture.at(2, 0), blue);
}

TEST(Layout, WipeTakesTheLeftHalfOfLeftAndTheRightHalfOfRight) {
    for (const int width : {1, 2, 5, 8}) {
        const Image picture = composed(Layout::wipe, {width, 2});
        EXPECT_EQ(picture.size, (Size{width, 2}));
        EXPECT_EQ(first_blue_column(picture, 0), (width + 1) / 2);
        EXPECT_EQ(first_blue_column(picture, 1), (width + 1) / 2);
    }
}

TEST(Layout, WipeTakesPixelsFromTheSamePlace) {
    Image left({4, 1}, red), right({4, 1}, blue);
    right.at(3, 0) = glm::vec4(9);
    right.at(0, 0) = glm::vec4(5);
    const Image picture = compose(Layout::wipe, std::vector{left, right});
    EXPECT_EQ(picture.at(3, 0), glm::vec4(9));
    EXPECT_EQ(picture.at(0, 0), red);
}

TEST(Layout, DifferenceIsSigned) {
    const Image picture = composed(Layout::difference, {3, 2});
    for (const glm::vec4 &pixel : picture.pixels) {
        EXPECT_EQ(pixel, glm::vec4(1, -0.25f, -1, 1));
    }
}

TEST(Layout, ASingleViewIsItself) { EXPECT_EQ(composed(Layout::single, {3, 2}).pixels, Image({3, 2}, red).pixels); }

TEST(Layout, ThreeUpSharesTheWidthAmongThree) {
    for (const int width : {3, 4, 5, 9, 100}) {
        const std::vector<Size> sizes = view_sizes(Layout::three_up, {width, 2});
        ASSERT_EQ(sizes.size(), 3U);
        EXPECT_EQ(sizes[0].width + sizes[1].width + sizes[2].width, width);
        EXPECT_LE(sizes[0].width - sizes[2].width, 1);
        const Image picture = compose(
            Layout::three_up, std::vector{Image(sizes[0], red), Image(sizes[1], blue), Image(sizes[2], glm::vec4(3))});
        EXPECT_EQ(picture.size, (Size{width, 2}));
        EXPECT_EQ(picture.at(sizes[0].width - 1, 1), red);
        EXPECT_EQ(picture.at(sizes[0].width, 1), blue);
        EXPECT_EQ(picture.at(width - 1, 0), glm::vec4(3));
    }
    EXPECT_THROW(view_sizes(Layout::three_up, {2, 5}), InputError);
}

TEST(Layout, OneColumnCannotHoldTwoViews) { EXPECT_THROW(view_sizes(Layout::side_by_side, {1, 5}), InputError); }

TEST(Layout, NamesRoundTrip) {
    for (const Layout layout : {Layout::single, Layout::side_by_side, Layout::wipe, Layout::difference}) {
        EXPECT_EQ(parse_layout(to_string(layout)), layout);
    }
    EXPECT_THROW(parse_layout("stacked"), InputError);
}

} // namespace
} // namespace sandbox

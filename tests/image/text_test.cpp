#include "image/text.h"

#include "image/glyphs.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>
#include <string>

namespace sandbox {
namespace {

ByteImage black(Size size) {
    return {size, std::vector<std::uint8_t>(3 * static_cast<std::size_t>(size.width) *
                                            static_cast<std::size_t>(size.height))};
}

std::string drawn(std::string_view text, double height = 40) {
    ByteImage image = black({60, 60});
    draw_text(image, 4, 4, height, text);
    return {image.rgb.begin(), image.rgb.end()};
}

TEST(Text, EveryCharacterLooksDifferent) {
    std::set<std::string> seen;
    for (char c = ' '; c <= '~'; ++c) {
        EXPECT_TRUE(seen.insert(drawn(std::string(1, c))).second) << c;
    }
}

TEST(Text, StrokesStayWithinTheLine) {
    for (char c = ' '; c <= '~'; ++c) {
        for (const char digit : glyph_strokes(c)) {
            EXPECT_TRUE(digit == ' ' || digit == '~' || (digit >= '0' && digit <= '9') || (digit >= 'a' && digit < 'k'))
                << c << ": " << digit;
        }
    }
}

TEST(Text, WidthScalesWithHeight) {
    EXPECT_DOUBLE_EQ(text_width("A per-pixel", 40), 2 * text_width("A per-pixel", 20));
    EXPECT_EQ(text_width("", 20), 0);
}

TEST(Text, UnknownCharactersAreQuestionMarks) { EXPECT_EQ(drawn("\xc3"), drawn("?")); }

TEST(Text, IsClippedToThePicture) {
    ByteImage image = black({20, 20});
    for (const auto &[x, y] : {std::pair{-30.0, -5.0}, {15.0, 15.0}, {500.0, 500.0}, {-1e9, 0.0}, {0.0, 1e9}}) {
        draw_text(image, x, y, 30, "clipped");
    }
    EXPECT_EQ(image.rgb.size(), 1200U);
    EXPECT_TRUE(std::any_of(image.rgb.begin(), image.rgb.end(), [](auto v) { return v == 255; }));
}

TEST(Text, StrokesThatCrossDoNotAddUp) {
    ByteImage image = black({60, 60});
    draw_text(image, 4, 4, 40, "+x#", {100, 50, 0});
    EXPECT_EQ(*std::max_element(image.rgb.begin(), image.rgb.end()), 100);
}

} // namespace
} // namespace sandbox

#include "ui/widgets/line_breaks.h"

#include "image/system_font.h"

#include <gtest/gtest.h>

namespace sandbox {
namespace {

/// In half widths of a Chinese character.
std::string lines(std::string_view text, float width) {
    return in_lines(text, width, [](char32_t code) { return code < first_chinese ? 1.0F : 2.0F; });
}

TEST(LineBreaks, StandBesideAnyChineseCharacter) {
    EXPECT_EQ(lines("高光在顶点之间", 6), "高光在\n顶点之\n间");
    EXPECT_EQ(lines("高光在顶点之间", 7), "高光在\n顶点之\n间"); // half a character is no room
    EXPECT_EQ(lines("高光在顶点之间", 14), "高光在顶点之间");
}

TEST(LineBreaks, KeepPunctuationWithItsWord) {
    EXPECT_EQ(lines("光，很亮。", 6), "光，很\n亮。");
    EXPECT_EQ(lines("很亮的光。", 8), "很亮的\n光。");       // not before what closes
    EXPECT_EQ(lines("它是（暗）的", 6), "它是\n（暗）\n的"); // not after what opens
    EXPECT_EQ(lines("他说“暗”了", 6), "他说\n“暗”了");
    EXPECT_EQ(lines("正在测量……", 8), "正在测\n量……");
}

TEST(LineBreaks, KeepLatinWordsAndNumbersWhole) {
    EXPECT_EQ(lines("光泽度 n = 32，很亮", 9), "光泽度 n\n= 32，很\n亮");
    EXPECT_EQ(lines("使用normalize函数", 10), "使用\nnormalize\n函数");
    EXPECT_EQ(lines("误差 5 %", 7), "误差\n5 %") << "a sign stays with its number";
}

TEST(LineBreaks, DivideAWordThatIsWiderThanALine) {
    EXPECT_EQ(lines("见abcdefgh", 4), "见\nabcd\nefgh");
    EXPECT_EQ(lines("光", 1), "光") << "a line has one character at least";
}

TEST(LineBreaks, KeepThoseOfTheText) {
    EXPECT_EQ(lines("高光\n在顶点之间", 6), "高光\n在顶点\n之间");
    EXPECT_EQ(lines("", 6), "");
}

TEST(LineBreaks, AreChineseWhereTheTextIs) {
    EXPECT_TRUE(has_chinese("A：亮"));
    EXPECT_TRUE(has_chinese("A，B"));
    EXPECT_FALSE(has_chinese("“A” – B"));
}

} // namespace
} // namespace sandbox

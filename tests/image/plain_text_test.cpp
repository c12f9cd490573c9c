#include "image/plain_text.h"

#include <gtest/gtest.h>

namespace sandbox {
namespace {

TEST(PlainText, IsHarmlessToATerminal) {
    EXPECT_EQ(plain_text("phong.glsl"), "phong.glsl");
    EXPECT_EQ(plain_text("张三.glsl"), "张三.glsl");
    EXPECT_EQ(plain_text("a\nb\t\x1B[2J"), "a\\x0Ab\\x09\\x1B[2J");
    EXPECT_EQ(plain_text("\xFFz"), "\\xFFz") << "no UTF-8";
    EXPECT_EQ(plain_text("\xC0\xAF"), "\\xC0\\xAF") << "a slash, overlong";
    EXPECT_EQ(plain_text("\xE2\x80\xAEgpj"), "\\xE2\\x80\\xAEgpj") << "right to left";
    EXPECT_EQ(plain_text("\xED\xA0\x80"), "\\xED\\xA0\\x80") << "half of a pair";
    EXPECT_EQ(plain_text("\xE5\xBC"), "\\xE5\\xBC") << "cut off";
}

TEST(PlainText, OfSeveralLinesKeepsThem) {
    EXPECT_EQ(plain_lines("a\n\tb\x1B]0;title\x07\r"), "a\n\tb\\x1B]0;title\\x07\\x0D");
    EXPECT_EQ(plain_lines("\xC2\x9B"
                          "2J"),
              "\\xC2\\x9B2J")
        << "a control of eight bits";
}

TEST(PlainText, IsUtf8) {
    for (const char *text : {"", "a", "\x1B", "\u5f20\u4e09", "\xF0\x9F\x98\x80"}) {
        EXPECT_TRUE(is_utf8(text)) << text;
    }
    for (const char *text : {"\xFF", "a\xE9", "\xC0\xAF", "\xED\xA0\x80", "\xE5\xBC"}) {
        EXPECT_FALSE(is_utf8(text));
    }
}

} // namespace
} // namespace sandbox

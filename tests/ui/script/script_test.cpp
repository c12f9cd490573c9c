#include "ui/script/script.h"

#include "image/error.h"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

namespace sandbox {
namespace {

TEST(Script, LinesAreWordsWithoutCommentsAndBlankOnes) {
    const std::vector<ScriptLine> lines =
        script_lines("s", "# all of it\n\nclick GLSL # the tab\r\nexpect \"A/name\" \"a b\"");
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_EQ(lines[0].number, 3);
    EXPECT_EQ(lines[0].words, (std::vector<std::string>{"click", "GLSL"}));
    EXPECT_EQ(lines[1].number, 4);
    EXPECT_EQ(lines[1].words, (std::vector<std::string>{"expect", "A/name", "a b"}));
    EXPECT_EQ(script_lines("s", "expect A \"\"")[0].words.back(), "");
    EXPECT_THROW(script_lines("s", "click \"GLSL"), InputError);
}

TEST(Script, KeysAreNamedAsTheListOfKeysNamesThem) {
    EXPECT_EQ(parse_key("F12").key, GLFW_KEY_F12);
    EXPECT_EQ(parse_key("m").key, GLFW_KEY_M);
    EXPECT_EQ(parse_key("4").key, GLFW_KEY_4);
    EXPECT_EQ(parse_key("Ctrl+Shift+Z").key, GLFW_KEY_Z);
    EXPECT_EQ(parse_key("Ctrl+Shift+Z").mods, GLFW_MOD_CONTROL | GLFW_MOD_SHIFT);
    EXPECT_EQ(parse_key("Ctrl++").key, GLFW_KEY_EQUAL);
    EXPECT_EQ(parse_key("PageDown").key, GLFW_KEY_PAGE_DOWN);
    for (const char *wrong : {"", "F0", "F26", "F1x", "Strg+Z", "Ctrl+", "Nothing"}) {
        EXPECT_THROW(parse_key(wrong), InputError) << wrong;
    }
}

} // namespace
} // namespace sandbox

#include "teach/marking/answer_names.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>

namespace sandbox {
namespace {

TEST(AnswerNames, AreNoFormulas) {
    for (const char *name : {"=1+1", "+1", "-1", "@a", "\ta", "\ra"}) {
        EXPECT_EQ(plain_cell(name).front(), '\'') << name;
    }
    EXPECT_EQ(plain_cell("a=1"), "a=1");
    EXPECT_EQ(plain_cell(""), "");
}

TEST(AnswerNames, GivePagesThatNoFileSystemMistakes) {
    const std::vector<std::string> names{"../../x.glsl",
                                         "/etc/passwd",
                                         "a\nb.glsl",
                                         "CON.glsl",
                                         "index",
                                         "A.glsl",
                                         "a.glsl",
                                         "-rf",
                                         "..",
                                         "\xFF.glsl",
                                         "com1.a",
                                         "张三.glsl",
                                         std::string(4000, 'n'),
                                         "",
                                         "a b&<.glsl"};
    const std::vector<std::string> pages = page_names(names);
    std::set<std::string> different;
    for (std::string page : pages) {
        EXPECT_EQ(page.find_first_of("/\\\n\"<>&:*?| "), std::string::npos) << page;
        EXPECT_LE(page.size(), 100U);
        EXPECT_NE(page.front(), '.');
        EXPECT_NE(page.front(), '-');
        std::ranges::transform(page, page.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
        EXPECT_TRUE(different.insert(page).second) << page;
        EXPECT_NE(page, "index.html");
    }
    EXPECT_EQ(pages[3], "_CON.glsl.html");
    EXPECT_EQ(pages[5], "A.glsl.html");
    EXPECT_EQ(pages[6], "a.glsl-2.html");
    EXPECT_EQ(pages[11], "张三.glsl.html");
    EXPECT_EQ(page_names(names), pages);
}

} // namespace
} // namespace sandbox

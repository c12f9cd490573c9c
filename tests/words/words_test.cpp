#include "words/words.h"

#include "image/error.h"
#include "tools/error_of.h"
#include "tools/temporary_folder.h"

#include <gtest/gtest.h>

namespace sandbox {
namespace {

TEST(Words, GiveTheTextOfAKey) {
    const Words words("zh", R"({"a.title": "光照", "b": "two"})", "words/zh.json");
    EXPECT_EQ(words.language(), "zh");
    EXPECT_EQ(words.text("a.title"), "光照");
    EXPECT_EQ(error_of([&] { (void)words.text("a"); }), "words/zh.json has no text \"a\"");
}

TEST(Words, FillInValuesInTheOrderOfTheLanguage) {
    const Words words("zh", R"({"of": "{1}的{0}"})", "words/zh.json");
    EXPECT_EQ(words.format("of", "法线", 2), "2的法线");
}

/// A folder of scenes (--assets) need not bring texts.
TEST(Words, AreThoseInsideTheExecutableWhereAFolderHasNone) {
    const TemporaryFolder folder;
    EXPECT_EQ(words_in("en", Assets("assets", folder.path())).all(), words_in("en").all());
    EXPECT_THROW((void)words_in("xx"), InputError);
}

TEST(Words, AreInEnglishWhereALanguageLacksThem) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder.path() / "words");
    folder.write("words/zh.json", R"({"a": "一"})");
    folder.write("words/en.json", R"({"a": "one", "b": "two"})");
    const Words words = words_in("zh", Assets("assets", folder.path()));
    EXPECT_EQ(words.text("a"), "一");
    EXPECT_EQ(words.text("b"), "two");
    EXPECT_EQ(words.english().text("a"), "one");
    EXPECT_EQ(words.find("b"), nullptr);
}

TEST(Words, RefuseWhatIsNoText) {
    EXPECT_EQ(error_of([] { Words("en", "[1]", "en.json"); }), "en.json: expected a JSON object of texts");
    EXPECT_EQ(error_of([] { Words("en", R"({"a": 1})", "en.json"); }), "en.json: a: expected a string, got 1");
}

TEST(Words, AreSpacedAsChineseIsWherePutTogether) {
    const Words chinese = words_in("zh");
    EXPECT_EQ(spaced(chinese, "A 与B的最大误差"), "A 与 B 的最大误差");
    EXPECT_EQ(spaced(chinese, "A 与 真值 的误差，与 逐面，Phong 之比"), "A 与真值的误差，与逐面，Phong 之比");
    EXPECT_EQ(spaced(chinese, "B 与颜色 (0, 0, 0)的误差"), "B 与颜色 (0, 0, 0) 的误差");
    EXPECT_EQ(spaced(chinese, "n = 32"), "n = 32");
    EXPECT_EQ(spaced(words_in("en"), "A 与B"), "A 与B");
}

} // namespace
} // namespace sandbox

#include "words/words.h"

#include "tools/error_of.h"

#include <gtest/gtest.h>

namespace sandbox {
namespace {

TEST(Words, GiveTheTextOfAKey) {
    const Words words("zh", R"({"a.title": "光照", "b": "two"})", "words/zh.json");
    EXPECT_EQ(words.language(), "zh");
    EXPECT_EQ(words.text("a.title"), "光照");
    EXPECT_EQ(error_of([&] { (void)words.text("a"); }), "words/zh.json has no text \"a\"");
}

TEST(Words, RefuseWhatIsNoText) {
    EXPECT_EQ(error_of([] { Words("en", "[1]", "en.json"); }), "en.json: expected a JSON object of texts");
    EXPECT_EQ(error_of([] { Words("en", R"({"a": 1})", "en.json"); }), "en.json: a: expected a string, got 1");
}

} // namespace
} // namespace sandbox

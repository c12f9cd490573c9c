#include "scene/read_json.h"

#include "image/error.h"
#include "tools/error_of.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace sandbox {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

std::string repeated(std::string_view text, std::size_t times) {
    std::string all;
    for (std::size_t i = 0; i < times; ++i) {
        all += text;
    }
    return all;
}

template <class Json> class ReadJson : public testing::Test {};
using Jsons = testing::Types<json, ordered_json>;
TYPED_TEST_SUITE(ReadJson, Jsons);

TYPED_TEST(ReadJson, BuildsWhatTheLibraryBuilds) {
    for (const char *text : {"null", "true", "3", "-3", "2.5", "\"a\\u00e9\"", "[]", "{}",
                             "[[1, [2, {}]], {\"b\": [], \"a\": {\"c\": 1}}]",
                             "{\"z\": 18446744073709551615, \"a\": {\"k\": [1, 2.5, \"s\", false, null]}, \"m\": -9}",
                             "\xEF\xBB\xBF{\"after\": \"a byte order mark\"}"}) {
        const auto read = read_json<TypeParam>(text, "a.json");
        EXPECT_EQ(read, TypeParam::parse(text)) << text;
        EXPECT_EQ(read.dump(), TypeParam::parse(text).dump()) << text << ": the order of keys";
    }
}

TYPED_TEST(ReadJson, RefusesWhatIsTooMuch) {
    const auto error = [](const std::string &text) { return error_of([&] { read_json<TypeParam>(text, "a.json"); }); };
    EXPECT_EQ(error(std::string(largest_json + 1, ' ')), "a.json: the file is larger than 16 MiB");
    const std::string deep = "a.json: nested deeper than 64 levels";
    EXPECT_EQ(error(std::string(1000000, '[')), deep);
    EXPECT_EQ(error(repeated("{\"a\":", 100000)), deep);
    EXPECT_EQ(error(repeated("[", 65) + repeated("]", 65)), deep);
    EXPECT_EQ(error(repeated("[", 64) + repeated("]", 64)), "no error");
    const std::string many = "a.json: expected at most 1000000 values, got more";
    EXPECT_EQ(error("[" + repeated("{},", most_json_values - 1) + "{}]"), many) << "the array is one, too";
    EXPECT_EQ(error("[" + repeated("0,", most_json_values - 2) + "0]"), "no error");
}

/// Of very many line ends the library's message would take half a gigabyte: what stands between them is read alike.
TYPED_TEST(ReadJson, ManyLineEndsChangeNothing) {
    const std::string lines = repeated("\n", 1000001), text = R"(["a\"\\", "\u000a", "b)";
    EXPECT_EQ(read_json<TypeParam>(lines + text + "\"]", "a.json").dump(), R"(["a\"\\","\n","b"])");
    const auto error = [](const std::string &bad) { return error_of([&] { read_json<TypeParam>(bad, "a.json"); }); };
    const std::string few = error("\n" + text + "\t\"]"), begin = "a.json:2:"; // a tab in a string
    EXPECT_TRUE(few.starts_with(begin)) << few;
    EXPECT_EQ(error(lines + text + "\t\"]"), "a.json:1000002:" + few.substr(begin.size()));
    EXPECT_TRUE(error("[" + lines + "x]").starts_with("a.json:1000002:1: "));
}

TYPED_TEST(ReadJson, ManyKeysAreReadWithoutDelay) { // a search through all keys for each would take minutes
    std::string text = "{";
    for (int i = 0; i < 500000; ++i) {
        text += "\"" + std::to_string(i) + "\":0,";
    }
    EXPECT_EQ(read_json<TypeParam>(text + "\"x\":0}", "a.json").size(), 500001U);
    EXPECT_EQ(error_of([&] { read_json<TypeParam>(text + "\"7\":0}", "a.json"); }),
              "a.json: 7: this key is given twice");
}

TYPED_TEST(ReadJson, SaysWhereAndWhat) {
    const auto error = [](const std::string &text) { return error_of([&] { read_json<TypeParam>(text, "a.json"); }); };
    EXPECT_EQ(error("{\"a\": [0, {\"b\": 1, \"b\": 2}]}"), "a.json: a[1].b: this key is given twice");
    EXPECT_EQ(error("{\"a\": [0, 1e999]}"), "a.json: a[1]: expected a finite number: number overflow parsing '1e999'");
    EXPECT_TRUE(error("{\n \"a\": nan}").starts_with("a.json:2:8: ")) << error("{\n \"a\": nan}");
    EXPECT_LT(error("[\"" + std::string(1000000, 'x')).size(), 400U);
    EXPECT_LT(error("{\"" + std::string(1000000, 'x') + "\": 1e999}").size(), 400U);
}

TEST(ShortJson, IsShortAndWhole) {
    EXPECT_EQ(short_json(json("a")), "\"a\"");
    EXPECT_EQ(short_json(json(std::vector<int>(1000, 0))), "an array of 1000");
    EXPECT_EQ(short_json(json(std::string(100, 'x'))).size(), 60U);
    // "é" has two bytes, and the 57th of the text is the first of one
    EXPECT_EQ(short_json(json(repeated("é", 100))), "\"" + repeated("é", 28) + "...");
}

TEST(BeginsObject, LooksAtTheFirstThing) {
    EXPECT_TRUE(begins_object("{"));
    EXPECT_TRUE(begins_object("\xEF\xBB\xBF \r\n\t{}"));
    for (const char *text : {"", " ", "[{}]", "v 0 0 0", "# {"}) {
        EXPECT_FALSE(begins_object(text)) << text;
    }
}

} // namespace
} // namespace sandbox

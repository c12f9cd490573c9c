#include "scene/obj_text.h"

#include <algorithm>
#include <charconv>
#include <gtest/gtest.h>
#include <random>

namespace sandbox {
namespace {

/// The lines' words, each line after its number.
std::string words_of(ObjText text) {
    std::string out;
    while (text.next_line()) {
        out += std::to_string(text.line_number()) + ":";
        for (std::string_view word = text.next_word(); !word.empty(); word = text.next_word()) {
            out += std::string(word) + ",";
        }
        out += "\n";
    }
    return out;
}

/// A source that hands over so many bytes at a time.
TextSource slow(std::string_view text, std::size_t at_once) {
    return [source = source_of(text), at_once](std::span<char> out) {
        return source(out.first(std::min(at_once, out.size())));
    };
}

TEST(ObjText, IsTheSameInWhateverPiecesItComes) {
    const std::string text = "# start\r\nv 1 2 \\\r\n 3 # three\r\n\rf a\\b c\\\nd\n\n  \t g\r#last \\\nend \\";
    const std::string expected = "1:\n2:v,1,2,3,\n4:\n5:f,a\\b,c,d,\n7:\n8:g,\n9:\n10:end,\n";
    EXPECT_EQ(words_of({source_of(text), "a"}), expected);
    for (std::size_t at_once = 1; at_once < 12; ++at_once) {
        EXPECT_EQ(words_of({slow(text, at_once), "a"}), expected) << at_once;
    }
}

TEST(ObjText, TakesLinesLongerThanABlock) {
    std::string text = "v";
    std::string expected = "1:v,";
    for (int i = 0; i < 200'000; ++i) {
        text += i % 1000 == 0 ? " \\\n " : " ";
        text += "12";
        expected += "12,";
    }
    EXPECT_EQ(words_of({source_of(text + "\nf"), "a"}), expected + "\n202:f,\n");
    const std::string one_word(1'000'000, 'x');
    EXPECT_EQ(words_of({source_of(one_word + "\rf"), "a"}), "1:" + one_word + ",\n2:f,\n");
}

TEST(ObjText, GivesTheRestOfALineWithTheBlanksInIt) {
    const auto rest = [](std::string_view line) {
        ObjText text(source_of(line), "a");
        text.next_line();
        text.next_word();
        return text.rest();
    };
    EXPECT_EQ(rest("usemtl  my  own\tred  "), "my  own\tred");
    EXPECT_EQ(rest("usemtl a \\\n b"), "a b");
    EXPECT_EQ(rest("usemtl a #b"), "a");
    EXPECT_EQ(rest("usemtl"), "");
}

/// The short way is exact: the same double as the standard library's, to the last bit.
TEST(ObjText, ReadsNumbersAsTheStandardLibraryDoes) {
    const ObjText text(source_of(""), "a");
    std::mt19937_64 dice(1);
    for (int i = 0; i < 100'000; ++i) {
        const auto digits = 1 + dice() % 17;
        std::string word = dice() % 2 == 0 ? "-" : "";
        const auto point = dice() % (digits + 2);
        for (std::size_t k = 0; k < digits; ++k) {
            word += k == point ? "." : "";
            word += static_cast<char>('0' + dice() % 10);
        }
        double expected = 0;
        std::from_chars(word.data(), word.data() + word.size(), expected);
        EXPECT_EQ(text.number(word, 1e300), expected) << word;
    }
}

} // namespace
} // namespace sandbox

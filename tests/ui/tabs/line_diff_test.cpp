#include "ui/tabs/line_diff.h"

#include <gtest/gtest.h>

namespace sandbox {
namespace {

using Lines = std::vector<std::string>;

TEST(LineDiff, SplitsLines) {
    EXPECT_EQ(split_lines("a\n\nb\n"), (Lines{"a", "", "b"}));
    EXPECT_EQ(split_lines("a"), (Lines{"a"}));
    EXPECT_TRUE(split_lines("").empty());
}

TEST(LineDiff, FindsWhatTheOtherLacks) {
    const Lines left{"in vec3 n;", "void main()", "{", "x();", "}"};
    const Lines right{"void main()", "{", "    x();", "y();", "}"};
    EXPECT_EQ(lines_missing(left, right), (std::vector<bool>{true, false, false, false, false}));
    EXPECT_EQ(lines_missing(right, left), (std::vector<bool>{false, false, false, true, false}));
}

TEST(LineDiff, OrderCounts) { EXPECT_EQ(lines_missing({"a", "b"}, {"b", "a"}), (std::vector<bool>{true, false})); }

TEST(LineDiff, NothingAgainstNothing) {
    EXPECT_TRUE(lines_missing({}, {"a"}).empty());
    EXPECT_EQ(lines_missing({"a"}, {}), (std::vector<bool>{true}));
}

TEST(LineDiff, MovedLinesAreFoundAndBracesAreNot) {
    const Lines lines{"    float d = length(v);", "{", ""};
    EXPECT_TRUE(holds_line(lines, "float d = length(v);"));
    EXPECT_FALSE(holds_line(lines, "{"));
    EXPECT_FALSE(holds_line(lines, ""));
    EXPECT_FALSE(holds_line(lines, "float d"));
}

} // namespace
} // namespace sandbox

#include "capture/labels.h"

#include "image/text.h"

#include <gtest/gtest.h>

namespace sandbox {
namespace {

const std::string long_label = "A  per vertex, Phong; normals: untransformed (wrong); gate: none (wrong)";

/// Every label is there to the last letter, within its view, in one size.
TEST(Labels, AreWholeAtAnyWidth) {
    for (const int width : {200, 320, 640, 1280, 1920, 3840}) {
        const LabelTexts texts{.labels = {long_label, "B  per pixel, Phong"}, .splits = {width / 2}};
        const Strips strips = strips_for(width, texts);
        ASSERT_EQ(strips.lines.size(), 2U) << width;
        for (std::size_t i = 0; i < 2; ++i) {
            std::string whole;
            for (const std::string &line : strips.lines[i]) {
                whole += (whole.empty() ? "" : " ") + line;
                EXPECT_LE(strips.lefts[i] + text_width(line, strips.text),
                          (i + 1) * static_cast<std::size_t>(width) / 2)
                    << width << line;
            }
            EXPECT_EQ(whole, texts.labels[i]);
        }
        EXPECT_GE(strips.above, strips.text * static_cast<double>(strips.lines[0].size()));
    }
}

TEST(Labels, AreLeftOutWhereTheyCannotBeRead) {
    EXPECT_EQ(strips_for(60, {.labels = {long_label}, .splits = {}}).above, 0);
    EXPECT_EQ(strips_for(60, {.labels = {}, .splits = {}, .scale = true}).below, 0);
    EXPECT_EQ(strips_for(600, {}).above, 0);
}

/// Over one view the second label goes where the divider is, as far as both stay whole.
TEST(Labels, FollowADividerAsFarAsTheyStayWhole) {
    LabelTexts texts{.labels = {"A  flat, Phong", "B  flat, Lambert"}, .splits = {500}, .splits_move = true};
    EXPECT_EQ(strips_for(1000, texts).lefts[1], 500);
    for (const int split : {0, 999}) {
        texts.splits = {split};
        const Strips strips = strips_for(1000, texts);
        EXPECT_GE(strips.lefts[1], text_width(texts.labels[0], strips.text));
        EXPECT_LE(strips.lefts[1] + text_width(texts.labels[1], strips.text), 1000);
    }
}

} // namespace
} // namespace sandbox

#include "capture/grid.h"

#include "image/error.h"

#include <gtest/gtest.h>

namespace sandbox {
namespace {

TEST(Grid, ACommaWithinBracketsBelongsToItsValue) {
    EXPECT_EQ(parse_sweep("lights[0].color=[1,0,0],[0,0.5,1]"), (Sweep{"lights[0].color", {"[1,0,0]", "[0,0.5,1]"}}));
    EXPECT_EQ(parse_sweep("objects[0].mesh={\"shape\":\"box\",\"divisions\":2},3").values.size(), 2U);
    EXPECT_EQ(parse_sweep("a=1").values, std::vector<std::string>{"1"});
}

TEST(Grid, WhatIsNoSweepIsRefused) {
    for (const char *text : {"", "a", "=1", "a=", "a=1,", "a=1,,2", "a=[1,2", "a=1]"}) {
        EXPECT_THROW(parse_sweep(text), InputError) << text;
    }
}

TEST(Grid, ItsSidecarHoldsIt) {
    const Grid grid{{parse_technique("flat/phong"), parse_technique("per-pixel/phong:gate=none")},
                    {"a", {"[1,2]", "3"}}};
    EXPECT_EQ(grid_of(grid_text(R"({"techniques": ["flat/phong"], "scene": {}})", grid), "g.json"), grid);
    EXPECT_FALSE(grid_of(R"({"techniques": ["flat/phong"], "scene": {}})", "g.json"));
    for (const char *wrong : {R"({"scene": {}, "sweep": "a=1"})", R"({"scene": {}, "sweep": "a=1", "rows": []})",
                              R"({"scene": {}, "sweep": "a=1", "rows": ["round/phong"]})"}) {
        EXPECT_THROW(grid_of(wrong, "g.json"), InputError) << wrong;
    }
}

/// Each cell is where its row and column say, as large as asked for; strips come on top.
TEST(Grid, CellsKeepTheirSizeAndPlace) {
    const std::vector<std::string> rows{"per vertex, Phong", "per pixel, Phong"}, columns{"shininess = 8", "64", "512"};
    const Size cell{120, 50};
    const ByteImage picture = grid_picture(rows, columns, cell, [&](std::size_t row, std::size_t column) {
        return ByteImage{cell,
                         std::vector<std::uint8_t>(3 * 120 * 50, static_cast<std::uint8_t>(100 + 10 * row + column))};
    });
    EXPECT_EQ(picture.size.width, 360);
    const int strips = picture.size.height - 100; // three alike
    EXPECT_EQ(strips % 3, 0);
    EXPECT_GE(strips, 3 * 15) << "text of 10 rows at least";
    for (int row = 0; row < 2; ++row) {
        for (int column = 0; column < 3; ++column) {
            const int x = column * 120 + 60, y = strips / 3 * (2 + row) + row * 50 + 25;
            EXPECT_EQ(picture.rgb[static_cast<std::size_t>(3 * (y * 360 + x))], 100 + 10 * row + column);
        }
    }
}

TEST(Grid, HasAtMost64Cells) {
    const std::vector<std::string> rows(8, "a"), columns(8, "b"), more(9, "b");
    const auto draw = [](std::size_t, std::size_t) { return ByteImage{{2, 2}, std::vector<std::uint8_t>(12)}; };
    EXPECT_NO_THROW(grid_picture(rows, columns, {2, 2}, draw));
    EXPECT_THROW(grid_picture(rows, more, {2, 2}, draw), InputError);
    EXPECT_THROW(grid_picture({}, columns, {2, 2}, draw), InputError);
    EXPECT_THROW(grid_picture(rows, columns, {4000, 2}, draw), InputError) << "32000 pixels wide";
}

} // namespace
} // namespace sandbox

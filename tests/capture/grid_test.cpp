#include "capture/grid.h"

#include "image/error.h"

#include <glm/vec4.hpp>
#include <gtest/gtest.h>
#include <variant>
#include <vector>

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

Scene ball() {
    Scene scene;
    scene.name = "ball";
    scene.lights.push_back({});
    scene.objects.push_back({.name = "ball", .mesh = SphereShape{}, .transform = {}, .material = {}});
    return scene;
}

TEST(SweepOfAMotion, IsEvenOverItsNumbers) {
    Motion motion{.mover = Mover::number, .path = "objects[0].material.shininess", .from = 8, .to = 64};
    EXPECT_EQ(sweep_of(motion, ball(), 5), (Sweep{motion.path, {"8", "22", "36", "50", "64"}}));
    motion.from = 1;
    motion.to = 0;
    motion.path = "lights[0].diffuse";
    EXPECT_EQ(sweep_of(motion, ball(), 3).values, (std::vector<std::string>{"1", "0.5", "0"}));
}

TEST(SweepOfAMotion, WholeNumbersStayWholeAndNoneStandsTwice) {
    const Motion motion{.mover = Mover::number, .path = "objects[0].mesh.rings", .from = 4, .to = 6};
    EXPECT_EQ(sweep_of(motion, ball(), 5).values, (std::vector<std::string>{"4", "5", "6"})) << "4, 4.5, 5, 5.5, 6";
}

/// Every value is one that the scene takes.
TEST(SweepOfAMotion, RoundingLeavesNoRange) {
    Motion motion{.mover = Mover::number, .path = "camera.fov_y_degrees", .from = 10, .to = 178.99999};
    EXPECT_EQ(sweep_of(motion, ball(), 2).values, (std::vector<std::string>{"10", "179"})) << "179 is accepted";
    motion.to = 400;
    EXPECT_EQ(sweep_of(motion, ball(), 2).values.back(), "179") << "the nearest that is";
}

TEST(SweepOfAMotion, WhatHasNoValuesIsRefused) {
    EXPECT_THROW(sweep_of({.mover = Mover::camera}, ball(), 5), InputError);
    EXPECT_THROW(sweep_of({.mover = Mover::number, .path = "lights[3].diffuse"}, ball(), 5), InputError);
    EXPECT_THROW(sweep_of({.mover = Mover::number, .path = "lights[0].diffuse", .from = 1, .to = 1}, ball(), 5),
                 InputError)
        << "one value";
}

/// The first row has A's meshes, the others B's; columns have the setting's values.
TEST(Grid, DrawsTechniquesDownAndValuesAcross) {
    struct Drawn {
        int rings;
        double diffuse;
        Technique technique;
        bool operator==(const Drawn &) const = default;
    };
    std::vector<Drawn> drawn;
    const DrawView draw = [&](const Scene &scene, const Technique &technique, Size size) {
        drawn.push_back({std::get<SphereShape>(scene.objects[0].mesh).rings, scene.lights[0].diffuse, technique});
        return Image(size, glm::vec4(0.5F));
    };
    const Technique a = parse_technique("flat/phong"), b = parse_technique("per-pixel/phong");
    PictureOptions options;
    options.size = {120, 40};
    options.mesh_factors = {0.25, 2};
    std::vector<double> shares;
    const ByteImage picture = draw_grid(ball(), {{a, b}, {"lights[0].diffuse", {"0.25", "0.5"}}}, options,
                                        {.draw = draw, .textbook = {}, .truth = {}}, "a test", [&](double share) {
                                            shares.push_back(share);
                                            return true;
                                        });
    EXPECT_EQ(picture.size.width, 240);
    EXPECT_EQ(drawn, (std::vector<Drawn>{{8, 0.25, a}, {8, 0.5, a}, {64, 0.25, b}, {64, 0.5, b}}));
    EXPECT_EQ(shares, (std::vector<double>{0.25, 0.5, 0.75, 1}));
    EXPECT_THROW(draw_grid(ball(), {{a}, {"lights[0].diffuse", {"0.25", "0.5"}}}, options,
                           {.draw = draw, .textbook = {}, .truth = {}}, "a test", [](double) { return false; }),
                 Cancelled);
}

} // namespace
} // namespace sandbox

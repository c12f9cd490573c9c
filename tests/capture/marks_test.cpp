#include "capture/marks.h"

#include "capture/picture.h"
#include "image/cut_paste.h"
#include "tools/english.h"
#include "tools/pixel.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace sandbox {
namespace {

ByteImage grey(Size size) {
    ByteImage picture = black_picture(size);
    std::ranges::fill(picture.rgb, std::uint8_t{100});
    return picture;
}
constexpr std::array<int, 3> untouched{100, 100, 100};

TEST(CutPaste, WhatIsCutOutAndPutBackChangesNothing) {
    ByteImage picture = black_picture({4, 3});
    for (std::size_t i = 0; i < picture.rgb.size(); ++i) {
        picture.rgb[i] = static_cast<std::uint8_t>(i);
    }
    const ByteImage part = cut(picture, 1, 1, {2, 2});
    EXPECT_EQ(pixel(part, 1, 0), (std::array<int, 3>{18, 19, 20})) << "column 2, row 1";
    ByteImage copy = picture;
    paste(copy, part, 1, 1);
    EXPECT_EQ(copy.rgb, picture.rgb);
}

TEST(Marks, ARingIsSeenOnDarkAndOnBright) {
    ByteImage view = grey({400, 200});
    draw_marks(view, english, {.pixel = {}, .profile = {}, .ring = glm::dvec3(0.5, 0.5, 0.25)}, {}, 10);
    // Its middle line lies 50 pixels around (200, 100); white is 2 wide, black 2 more on each side.
    for (const auto &[x, y] : {std::pair(249, 100), std::pair(150, 100), std::pair(200, 50), std::pair(200, 149)}) {
        EXPECT_EQ(pixel(view, x, y), (std::array<int, 3>{255, 255, 255})) << x << "," << y;
    }
    EXPECT_EQ(pixel(view, 247, 100), (std::array<int, 3>{0, 0, 0}));
    EXPECT_EQ(pixel(view, 252, 100), (std::array<int, 3>{0, 0, 0}));
    EXPECT_EQ(pixel(view, 200, 100), untouched);
    EXPECT_EQ(pixel(view, 260, 100), untouched);
}

/// An orthographic view two units high: an arrow across it is a quarter of its height long.
TEST(Marks, ArrowsLieWhereTheirVectorsPoint) {
    Scene scene;
    scene.camera.position = {0, 0, 5};
    scene.camera.target = {0, 0, 0};
    scene.camera.projection = Projection::orthographic;
    scene.camera.height = 2;
    scene.lights.resize(1);
    PixelProbe probe;
    probe.normal = {1, 0, 0};
    probe.view = {0, 0, 1};
    probe.lights.resize(1);
    probe.lights[0].terms.vectors.l = {0, 1, 0};
    probe.lights[0].terms.vectors.h = {0, -1, 0};
    const std::vector<Arrow> arrows = arrows_of(scene, Model::blinn_phong, probe, 2);
    const std::vector<std::pair<std::string, glm::dvec2>> expected{
        {"H", {0.5, 0.75}}, {"L", {0.5, 0.25}}, {"V", {0.5, 0.5}}, {"N", {0.625, 0.5}}};
    ASSERT_EQ(arrows.size(), expected.size());
    for (std::size_t i = 0; i < arrows.size(); ++i) {
        EXPECT_EQ(arrows[i].name, expected[i].first);
        EXPECT_NEAR(arrows[i].to.x, expected[i].second.x, 1e-12) << arrows[i].name; // a few roundings of numbers near 1
        EXPECT_NEAR(arrows[i].to.y, expected[i].second.y, 1e-12) << arrows[i].name;
    }
    EXPECT_EQ(arrows_of(scene, Model::lambert, probe, 2).size(), 3U) << "neither R nor H";
}

TEST(Marks, AProfileIsALineAcross) {
    ByteImage view = grey({50, 40});
    draw_marks(view, english, {.pixel = {}, .profile = 0.5125}, {}, 10); // the middle of row 20
    for (const int x : {0, 25, 49}) {
        EXPECT_EQ(pixel(view, x, 20), (std::array<int, 3>{255, 255, 255}));
        EXPECT_EQ(pixel(view, x, 17), untouched);
        EXPECT_EQ(pixel(view, x, 23), untouched);
    }
}

TEST(Marks, TheLoupesMiddleIsThePixel) {
    ByteImage view = grey({300, 300});
    view.rgb[3 * (200 * 300 + 60)] = 255;
    draw_marks(view, english, {.pixel = glm::dvec2(60.5 / 300, 200.5 / 300), .loupe = true, .profile = {}}, {}, 10);
    EXPECT_EQ(pixel(view, 60, 200), (std::array<int, 3>{255, 100, 100})) << "the picture below stays";
    // 120 pixels (12 texts of 10) in the upper right corner, 6 from its edges; a cell has 120 / 21.
    const int x = 300 - 6 - 60, y = 6 + 60;
    EXPECT_EQ(pixel(view, x, y), (std::array<int, 3>{255, 100, 100}));
    EXPECT_EQ(pixel(view, x + 6, y), untouched) << "its neighbour";
    EXPECT_EQ(pixel(view, 100, 100), untouched);
}

TEST(Marks, TheyLieOverEveryViewAndInNoStrip) {
    PictureOptions options;
    options.layout = Layout::side_by_side;
    options.size = {400, 200};
    options.labels = true;
    const DrawView blue = [](const Scene &, const Technique &, Size size) {
        return Image(size, glm::vec4(0, 0, 1, 1));
    };
    Size probed;
    const Painters painters{blue, blue, blue, [&](const Scene &, const Technique &technique, Size size, int x, int y) {
                                EXPECT_EQ(to_string(technique), "per-pixel/blinn-phong");
                                EXPECT_EQ(x, size.width - 1);
                                EXPECT_EQ(y, 0);
                                probed = size;
                                return std::optional<PixelProbe>{};
                            }};
    const ByteImage plain = show_picture({}, options, painters);
    options.marks = {.pixel = glm::dvec2(1, 0), .vectors = true, .profile = 0.0};
    const ByteImage marked = show_picture({}, options, painters);
    const int strip = options.size.height - room_for_views(options).height;
    EXPECT_EQ(probed, (Size{200, 200 - strip}));
    EXPECT_EQ(cut(marked, 0, 0, {400, strip}).rgb, cut(plain, 0, 0, {400, strip}).rgb);
    for (const int x : {50, 350}) {
        EXPECT_NE(pixel(marked, x, strip), pixel(plain, x, strip));
    }
}

TEST(Marks, LightsLieOverEveryView) {
    Scene scene;
    scene.camera.position = {0, 0, 8};
    scene.lights.resize(2);
    scene.lights[0].color = {1, 0, 0};
    scene.lights[1].position = {0, 0, 9}; // behind the camera
    PictureOptions options;
    options.layout = Layout::side_by_side;
    options.size = {400, 200};
    const DrawView grey = [](const Scene &, const Technique &, Size size) {
        return Image(size, glm::vec4(0.4F, 0.4F, 0.4F, 1));
    };
    const Painters painters{grey, grey, grey};
    const ByteImage plain = show_picture(scene, options, painters);
    options.drawn_over.lights = true;
    const ByteImage marked = show_picture(scene, options, painters);
    for (const int x : {100, 300}) {
        EXPECT_EQ(pixel(marked, x, 100), (std::array<int, 3>{255, 90, 90}));
        EXPECT_EQ(pixel(marked, x, 150), pixel(plain, x, 150));
    }
    scene.lights[1].position = {};
    EXPECT_TRUE(light_marks(scene, 1)[1].named);
    EXPECT_EQ(english.format("light.numbered", 2), "light 2");
    scene.lights[0].enabled = false;
    EXPECT_FALSE(light_marks(scene, 1)[0].named) << "no other is on";
}

} // namespace
} // namespace sandbox

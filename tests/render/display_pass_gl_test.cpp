#include "render/display_pass.h"

#include "image/difference.h"
#include "render/renderer.h"
#include "scene/scene_file.h"
#include "tools/gl_test.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <glad/gl.h>
#include <limits>
#include <random>

namespace sandbox {
namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
constexpr float infinite = std::numeric_limits<float>::infinity();
constexpr float largest = std::numeric_limits<float>::max();

/// Top row first, as to_display() has it.
std::vector<std::uint8_t> read_rgb(const DisplayTexture &texture) {
    const Size size = texture.size();
    std::vector<std::array<std::uint8_t, 4>> row(static_cast<std::size_t>(size.width));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, texture.framebuffer());
    std::vector<std::uint8_t> rgb;
    for (int y = size.height - 1; y >= 0; --y) {
        glReadPixels(0, y, size.width, 1, GL_RGBA, GL_UNSIGNED_BYTE, row.data());
        for (const auto &pixel : row) {
            rgb.insert(rgb.end(), pixel.begin(), pixel.begin() + 3);
        }
    }
    return rgb;
}

class DisplayPasses : public GlTest {
  protected:
    /// Shows `image`; returns how many pixels were counted as not finite.
    unsigned show(const Image &image, float exposure) {
        Target target(image.size);
        target.write_color(image);
        DisplayTexture texture(image.size);
        const unsigned counted = DisplayPass(ShaderParts(Assets("shaders")))
                                     .run(target, texture, {Display::linear, static_cast<double>(exposure)});
        shown_ = read_rgb(texture);
        return counted;
    }
    std::vector<std::uint8_t> shown_;
};

TEST_F(DisplayPasses, CountsWhatIsNotFiniteAndNothingElse) {
    Image image({67, 35}, glm::vec4(0.25F, 0.5F, 1, 1)); // no multiple of any tile
    image.at(0, 0).r = not_a_number;
    image.at(66, 0).g = -not_a_number;
    image.at(0, 34).b = infinite;
    image.at(66, 34).r = -infinite;
    image.at(33, 17) = glm::vec4(not_a_number, infinite, -infinite, 1); // one pixel
    image.at(1, 1) = glm::vec4(largest, -largest, 0, 1);
    image.at(2, 1) = glm::vec4(-1, -0.0F, std::numeric_limits<float>::denorm_min(), 1);
    image.at(3, 1).a = not_a_number; // no display shows it
    EXPECT_EQ(show(image, 1), 5U);
    EXPECT_EQ(shown_, to_display(image).rgb);
}

TEST_F(DisplayPasses, ExposureMakesNothingNonFinite) {
    const Image image({8, 8}, glm::vec4(largest, 0.5F, 0, 1));
    EXPECT_EQ(show(image, 1e6F), 0U);
    EXPECT_EQ(shown_, to_display(image, Display::linear, 1e6).rgb);
}

TEST_F(DisplayPasses, ADifferenceShowsWhatIsNotFinite) {
    Image left({3, 1}, glm::vec4(0.25F)), right = left;
    left.at(0, 0).r = not_a_number;
    right.at(1, 0).b = not_a_number;
    Target a(left.size), b(right.size);
    a.write_color(left);
    b.write_color(right);
    DisplayTexture texture(left.size);
    DisplayPass(ShaderParts(Assets("shaders"))).run_difference(a, b, texture, 1);
    EXPECT_EQ(read_rgb(texture), (std::vector<std::uint8_t>{255, 0, 255, 255, 0, 255, 255, 255, 255}));
}

/// A level apart at most: where 255 times a colour lies halfway between two, float32 may round either way.
TEST_F(DisplayPasses, ADifferenceIsTheOneThatFilesHold) {
    Image left({61, 37}), right(left.size);
    std::mt19937 random(7);
    std::uniform_real_distribution<float> light(-0.25F, 1.5F);
    for (std::size_t i = 0; i < left.pixels.size(); ++i) {
        left.pixels[i] = {light(random), light(random), light(random), 1};
        right.pixels[i] = i % 3 == 0 ? left.pixels[i] : glm::vec4(light(random), light(random), light(random), 1);
    }
    left.at(5, 5).g = infinite;
    right.at(9, 0).r = not_a_number;
    Target a(left.size), b(right.size);
    a.write_color(left);
    b.write_color(right);
    DisplayTexture texture(left.size);
    DisplayPass(ShaderParts(Assets("shaders"))).run_difference(a, b, texture, 1.7F);
    const std::vector<std::uint8_t> shown = read_rgb(texture), filed = difference_picture(left, right, 1.7F).rgb;
    ASSERT_EQ(shown.size(), filed.size());
    for (std::size_t i = 0; i < shown.size(); ++i) {
        ASSERT_NEAR(shown[i], filed[i], 1) << "pixel " << i / 3;
    }
}

TEST_F(DisplayPasses, AFinishedPictureIsShownAsItIs) {
    const ByteImage picture{{3, 2}, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 253, 254, 255}};
    EXPECT_EQ(read_rgb(DisplayTexture(picture)), picture.rgb);
}

/// Drawn in one step or in two: a level apart at most, as above.
TEST_F(DisplayPasses, WhatIsDrawnAsShownIsWhatIsShownOfItsLight) {
    Renderer renderer(Assets("assets"), ShaderParts(Assets("shaders")));
    const Size size{160, 96};
    for (const std::string &name : builtin_scenes(Assets("assets"))) {
        const Scene scene = open_scene(name, Assets("assets"));
        for (const DisplayMap map : {DisplayMap{}, DisplayMap{Display::srgb, 2.5}}) {
            ScreenTarget screen(size);
            const Technique technique{.frequency = Frequency::per_pixel, .model = Model::blinn_phong};
            renderer.draw_shown(scene, technique, map, screen);
            const auto shown = read_window_surface(screen.framebuffer(), size).rgb;
            const auto light = to_display(renderer.render(scene, technique, size).color, map.curve, map.exposure).rgb;
            int farthest = 0;
            for (std::size_t i = 0; i < light.size(); ++i) {
                farthest = std::max(farthest, std::abs(shown[i] - light[i]));
            }
            EXPECT_LE(farthest, 1) << name;
        }
    }
}

TEST_F(DisplayPasses, TheBackgroundIsExposedToo) {
    Renderer renderer(Assets("assets"), ShaderParts(Assets("shaders")));
    Scene scene = open_scene("box-1-colour", Assets("assets"));
    scene.background = glm::dvec3(0.25);
    ScreenTarget screen({8, 8});
    scene.objects.clear();
    renderer.draw_shown(scene, {}, {Display::linear, 2}, screen);
    const auto shown = read_window_surface(screen.framebuffer(), screen.size()).rgb;
    EXPECT_EQ(shown, to_display(Image(screen.size(), glm::vec4(0.25F)), Display::linear, 2).rgb);
}

TEST_F(DisplayPasses, AWholePictureMayBeNonFinite) {
    EXPECT_EQ(show(Image({31, 9}, glm::vec4(not_a_number)), 1), 31U * 9U);
    EXPECT_EQ(show(Image({31, 9}, glm::vec4(0)), 1), 0U);
}

} // namespace
} // namespace sandbox

#include "capture/samples.h"
#include "render/renderer.h"
#include "scene/space.h"
#include "shading/vertex_marks.h"
#include "tools/gl_test.h"

#include <algorithm>
#include <cmath>

namespace sandbox {
namespace {

constexpr Overlays normals{.wireframe = false, .normals = true, .vertices = false, .lights = false};
constexpr Overlays vertices{.wireframe = false, .normals = false, .vertices = true, .lights = false};
constexpr Overlays wireframe{.wireframe = true, .normals = false, .vertices = false, .lights = false};

/// Black things before nothing, 8 units high, seen along -z without perspective.
Scene black_scene() {
    Scene scene;
    scene.camera.position = {0, 0, 10};
    scene.camera.projection = Projection::orthographic;
    scene.camera.height = 8;
    return scene;
}

/// A plane of one square whose normals point to the right and up, at 45 degrees.
Object tilted_plane() { return {"plane", PlaneShape{{4, 4}, 1}, {{0, 0, 0}, {0, 0, -45}, glm::dvec3(1)}, {}, true}; }

class OverlaysGl : public GlTest {
  protected:
    Image drawn(const Scene &scene, const Overlays &overlays, Size size,
                const std::string &technique = "per-pixel/lambert") {
        Target target(size);
        renderer_.draw(scene, parse_technique(technique), target);
        renderer_.draw_overlays(scene, parse_technique(technique), overlays, target);
        return target.read_color();
    }
    Renderer renderer_{Assets("assets"), ShaderParts(Assets("shaders"))};
};

/// Of all pixels, in units of a whole one of `color`.
double covered(const Image &image, const glm::vec3 &color) {
    double sum = 0;
    for (const glm::vec4 &pixel : image.pixels) {
        sum += static_cast<double>(pixel.g / color.g);
    }
    return sum;
}

TEST_F(OverlaysGl, ANormalEndsWhereItsTipLies) {
    Scene scene = black_scene();
    scene.objects = {tilted_plane()};
    const Size size{480, 480};
    const Image image = drawn(scene, normals, size);
    // The plane's four corners lie two by two at (+-1.414, -+1.414); seen from its edge it is a line.
    const double per_unit = size.height / 8.0;
    double top = size.height;
    int right = 0;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            if (image.at(x, y).g > 0.4F) {
                top = std::min(top, static_cast<double>(y));
                right = std::max(right, x);
            }
        }
    }
    const double tip = std::sqrt(2.0) + normal_length * 8 * std::sqrt(0.5);
    constexpr double pixels = 1.5; // half of a line's width, and half a pixel
    EXPECT_NEAR(top, size.height / 2.0 - tip * per_unit, pixels);
    EXPECT_NEAR(right, size.width / 2.0 + tip * per_unit, pixels);
    EXPECT_TRUE(std::ranges::all_of(image.pixels, [](const glm::vec4 &pixel) { return pixel.a == 1; }));
}

TEST_F(OverlaysGl, AFaultTiltsTheNormalsOfItsSideAlone) {
    Scene scene = black_scene();
    scene.objects = {tilted_plane()};
    scene.objects[0].transform = {{}, {0, 0, 0}, {1, 3, 1}};
    scene.objects[0].mesh = SphereShape{1, 8, 16};
    const Size size{240, 240};
    const Image right = drawn(scene, normals, size);
    const Image wrong = drawn(scene, normals, size, "per-pixel/lambert:normals=model-matrix");
    EXPECT_NE(right.pixels, wrong.pixels);
    EXPECT_EQ(right.pixels, drawn(scene, normals, size, "per-vertex/lambert").pixels);
    EXPECT_EQ(drawn(scene, vertices, size).pixels,
              drawn(scene, vertices, size, "per-pixel/lambert:normals=model-matrix").pixels);
}

TEST_F(OverlaysGl, WhatASurfaceHidesIsNotDrawn) {
    Scene scene = black_scene();
    scene.objects = {{"ball", SphereShape{1, 12, 24}, {}, {}, false}};
    const Size size{240, 240};
    Scene hidden = scene;
    hidden.objects.push_back({"wall", BoxShape{{4, 4, 0.1}, 1}, {{0, 0, 3}, {}, glm::dvec3(1)}, {}, false});
    Scene wall = hidden;
    wall.objects.erase(wall.objects.begin());
    for (const Overlays &overlays : {normals, vertices}) {
        EXPECT_GT(covered(drawn(scene, overlays, size), glm::vec3(1)), 200);
        EXPECT_EQ(drawn(hidden, overlays, size).pixels, drawn(wall, overlays, size).pixels);
    }
}

/// Of a box's corners the farthest is hidden; the dots of the others lie whole before the faces that meet there.
TEST_F(OverlaysGl, ACornersDotLiesBeforeItsFaces) {
    Scene scene = black_scene();
    scene.objects = {{"box", BoxShape{{3, 3, 3}, 1}, {{}, {25, 30, 0}, glm::dvec3(1)}, {}, false}};
    const Size size{240, 240};
    const Image image = drawn(scene, vertices, size);
    const glm::dmat3 turn = linear_part(scene.objects[0].transform);
    double farthest = 0;
    for (int i = 0; i < 8; ++i) {
        farthest = std::min(farthest, (turn * (1.5 * glm::dvec3(i % 2 * 2 - 1, i / 2 % 2 * 2 - 1, i / 4 * 2 - 1))).z);
    }
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 corner = turn * (1.5 * glm::dvec3(i % 2 * 2 - 1, i / 2 % 2 * 2 - 1, i / 4 * 2 - 1));
        const auto place = place_in_view(scene.camera, 1, corner - scene.camera.position);
        ASSERT_TRUE(place);
        for (const glm::dvec2 off : {glm::dvec2(0), glm::dvec2(-1, -1), glm::dvec2(1, -1), glm::dvec2(0, 1)}) {
            const glm::dvec2 at = *place * 240.0 + off;
            const bool is_dot = image.at(static_cast<int>(at.x), static_cast<int>(at.y)).g > 0.6F;
            EXPECT_EQ(is_dot, corner.z > farthest) << i;
        }
    }
}

TEST_F(OverlaysGl, DeepScenesAndHugeOnesShowTheSame) {
    Scene usual;
    usual.camera.position = {0.3, 0.6, 4};
    usual.camera.near_plane = 0.5;
    usual.camera.far_plane = 60;
    usual.objects = {{"ball", SphereShape{0.6, 12, 24}, {{0.2, 0, 1}, {}, glm::dvec3(1)}, {}, false},
                     {"box", BoxShape{{2, 2, 2}, 8}, {{-0.2, 0, -1}, {0, 20, 0}, glm::dvec3(1)}, {}, false}};
    Scene deep = usual;
    deep.camera.near_plane = 1e-4;
    deep.camera.far_plane = 1e6;
    Scene huge = usual;
    const double factor = 0x1p60; // beyond float32's squares; the vertices are the same numbers
    huge.camera.position *= factor;
    huge.camera.target *= factor;
    huge.camera.near_plane *= factor;
    huge.camera.far_plane *= factor;
    for (Object &object : huge.objects) {
        object.transform.translate *= factor;
        object.transform.scale *= factor;
    }
    const Size size{320, 240};
    for (const Overlays &overlays : {normals, vertices}) {
        const Image expected = drawn(usual, overlays, size);
        const double all = covered(expected, glm::vec3(1));
        EXPECT_GT(all, 500);
        for (const Scene *scene : {&deep, &huge}) {
            double other = 0;
            const Image got = drawn(*scene, overlays, size);
            for (std::size_t i = 0; i < got.pixels.size(); ++i) {
                other += static_cast<double>(std::abs(got.pixels[i].g - expected.pixels[i].g));
            }
            EXPECT_LT(other, 0.02 * all) << "depth is rounded otherwise where surfaces and lines meet";
        }
    }
}

/// A line of a wireframe has one pixel a column where it is more level than steep, else one a row: as many in all as
/// its longer side, at any size of the picture and, on average, with any number of samples.
TEST_F(OverlaysGl, AWireframesLinesAreOnePixelThin) {
    Scene scene = black_scene();
    scene.objects = {tilted_plane()};
    scene.objects[0].transform.rotate_degrees = {60, 0, 25};
    const glm::dmat3 turn = linear_part(scene.objects[0].transform);
    const glm::dvec3 x = turn * glm::dvec3(4, 0, 0), z = turn * glm::dvec3(0, 0, 4);
    const auto longer = [](const glm::dvec3 &side) { return std::max(std::abs(side.x), std::abs(side.y)); };
    for (const int scale : {1, 2}) {
        const Size size{320 * scale, 320 * scale};
        const double per_unit = size.height / 8.0;
        const double once = (2 * longer(x) + 2 * longer(z)) * per_unit;
        const double diagonals[] = {longer(x + z) * per_unit, longer(x - z) * per_unit};
        for (const int samples : {1, 16}) {
            const Image mean =
                draw_samples(scene, size, samples, [&](const Scene &sample) { return drawn(sample, wireframe, size); });
            const double found = covered(mean, overlay_kinds[0].color);
            const double off = std::min(std::abs(found - once - diagonals[0]), std::abs(found - once - diagonals[1]));
            EXPECT_LT(off, 12) << scale << " " << samples << ": the corners, and where the diagonal is drawn twice";
        }
    }
}

} // namespace
} // namespace sandbox

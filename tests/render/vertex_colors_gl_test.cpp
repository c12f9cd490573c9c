#include "measure/metrics/metrics.h"
#include "reference/reference.h"
#include "render/renderer.h"
#include "scene/obj_reader.h"
#include "shading/own_text.h"
#include "shading/technique.h"
#include "tools/gl_test.h"

#include <cmath>
#include <fmt/format.h>
#include <memory>
#include <utility>

/// Colours of a model's vertices: the base colour is multiplied by them, between the vertices and under every
/// frequency.
namespace sandbox {
namespace {

constexpr Size size{96, 72};

/// In z = 0; where it is red and green, and how much, says where one is in it.
const std::string square = "v -1 -1 0 0 0 0.5\nv 1 -1 0 1 0 0.5\nv 1 1 0 1 1 0.5\nv -1 1 0 0 1 0.5\n"
                           "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n";

Object object_of(const std::string &obj) {
    Object object;
    object.mesh = ObjShape{"/in memory.obj", std::nullopt, std::make_shared<const Mesh>(read_obj(obj, "a.obj"))};
    return object;
}

/// The square, seen from the front at a distance of 4, in light from everywhere.
Scene flat_scene() {
    Scene scene;
    scene.camera.position = {0, 0, 4};
    scene.ambient = {1, 1, 1};
    scene.objects = {object_of(square)};
    return scene;
}

/// Three tilted squares: one of its colours alone, one with a texture and one with a chequer besides, which colour the
/// highlight or do not.
Scene lit_scene() {
    Scene scene;
    scene.camera.position = {0.4, 0.6, 4};
    scene.ambient = {0.05, 0.05, 0.1};
    scene.objects = {object_of(square), object_of(square), object_of(square)};
    for (int i = 0; i < 3; ++i) {
        Object &object = scene.objects[static_cast<std::size_t>(i)];
        object.transform = {{1.6 * (i - 1), 0.1 * i, 0}, {10.0 * i, 20, 5}, {0.7, 0.7, 0.7}};
        object.material.emission = {0.02, 0, 0.01};
        object.two_sided = i == 2;
    }
    scene.objects[1].material.texture = "tiles.png";
    scene.objects[1].material.texture_modulates_specular = false;
    scene.objects[2].material.checker = Checker{};
    Light point;
    point.position = {-1, 2, 3};
    point.attenuation = {0.5, 0.1, 0.02};
    point.ambient = 0.1;
    Light sun;
    sun.type = LightType::directional;
    sun.direction = {0.3, -0.2, -1};
    scene.lights = {point, sun};
    return scene;
}

class VertexColors : public GlTest {
  protected:
    Renderer renderer_{Assets("assets"), ShaderParts(Assets("shaders"))};

    double error(const Scene &scene, const Technique &technique, const Technique &truth) {
        const Metrics metrics =
            compare(renderer_.render(scene, technique, size, true),
                    render_reference(scene, renderer_.resources().load(scene), truth, size), Flip::without);
        EXPECT_EQ(metrics.nonfinite_pixels, 0U);
        EXPECT_GT(metrics.compared_pixels, 1000U);
        return metrics.norms.max_abs;
    }
};

/// colour = ambient * (x + 1, y + 1, 1) / 2 at (x, y) of the square, which is linear: no interpolation can err but by
/// rounding (2e-6: 16 steps of float32 at 1).
TEST_F(VertexColors, AreInterpolatedUnderEveryFrequencyAndProgram) {
    const Scene scene = flat_scene();
    const double half = std::tan(22.5 * 3.14159265358979323846 / 180) * 4; // of the picture's height, in the square
    for (const Frequency frequency : all_frequencies) {
        for (const Program program : {Program::specialised, Program::full}) {
            const Technique technique{.frequency = frequency, .program = program};
            const Image drawn = renderer_.render(scene, technique, size).color;
            for (const auto &[column, row] : {std::pair(48, 36), {60, 36}, {40, 50}, {35, 20}, {61, 22}}) {
                const double x = (2 * (column + 0.5) / size.width - 1) * half * size.width / size.height;
                const double y = (1 - 2 * (row + 0.5) / size.height) * half;
                const glm::vec4 pixel = drawn.at(column, row);
                EXPECT_NEAR(pixel.r, (x + 1) / 2, 2e-6) << to_string(technique);
                EXPECT_NEAR(pixel.g, (y + 1) / 2, 2e-6) << to_string(technique);
                EXPECT_NEAR(pixel.b, 0.5, 2e-6) << to_string(technique);
            }
        }
    }
}

/// The truth has them, too. 5e-5: the bound of random scenes (facing_gl_test.cpp).
TEST_F(VertexColors, AreTheTruthBesideTexturesChequersAndLights) {
    const Scene scene = lit_scene();
    for (const Frequency frequency : all_frequencies) {
        for (const Model model : all_models) {
            for (const Program program : {Program::specialised, Program::full}) {
                const Technique technique{.frequency = frequency, .model = model, .program = program};
                EXPECT_LE(error(scene, technique, technique), 5e-5) << to_string(technique);
            }
        }
    }
}

/// base() of own shading holds them, whichever stage calls it. 4e-4: textbook float32 (own_shading_gl_test.cpp).
TEST_F(VertexColors, AreInWhatOwnShadingIsGiven) {
    const Scene scene = lit_scene();
    const std::string text = "vec3 lighting(vec3 P, vec3 N, vec3 eye)\n{\n"
                             "    return material.emission + base() * material.ambient * scene_ambient;\n}\n";
    Scene ambient = scene;
    ambient.lights.clear();
    for (const Frequency frequency : {Frequency::flat, Frequency::per_vertex, Frequency::per_pixel}) {
        const Technique own = parse_technique_with(OwnShader("own.glsl", text),
                                                   fmt::format("{}/own", frequency_values[int(frequency)].name));
        EXPECT_LE(error(ambient, own, {.frequency = frequency}), 4e-4) << to_string(own);
    }
}

} // namespace
} // namespace sandbox

#include "image/error.h"
#include "measure/metrics/metrics.h"
#include "reference/reference.h"
#include "render/gl_program.h"
#include "render/renderer.h"
#include "scene/scene_file.h"
#include "shading/own_files.h"
#include "shading/own_text.h"
#include "shading/prepared_object.h"
#include "tools/gl_test.h"

#include <fmt/format.h>

namespace sandbox {
namespace {

constexpr Size size{160, 120};

class OwnShading : public GlTest {
  protected:
    Renderer renderer{Assets("assets"), ShaderParts(Assets("shaders"))};

    static Technique own(Frequency frequency, const std::string &text) {
        return parse_technique_with(OwnShader("own.glsl", text),
                                    fmt::format("{}/own", frequency_values[int(frequency)].name));
    }
    static Scene scene_named(const std::string &name) { return open_scene(name, Assets("assets")); }
    std::string failure(const Technique &technique) {
        try {
            renderer.render(scene_named("point-light"), technique, size);
            return "";
        } catch (const InputError &error) {
            return error.what();
        }
    }
    /// Largest difference over the pixels that can be compared.
    double error_of(const Scene &scene, const Technique &technique, const Technique &truth) {
        const Frame drawn = renderer.render(scene, technique, size, true);
        const Metrics metrics =
            compare(drawn, render_reference(scene, renderer.resources().load(scene), truth, size, Surface::mesh, {}));
        EXPECT_GT(metrics.compared_pixels, 500U) << scene.name;
        return metrics.norms.max_abs;
    }
};

std::string body(const std::string &lines) { return "vec3 lighting(vec3 P, vec3 N, vec3 eye)\n{\n" + lines + "\n}\n"; }

/// Textbook float32 in world space: pow() errs by some 1e-4 of a highlight at these exponents (shading equations,
/// "stiff highlights"), and P by 6e-8 of the distance from the origin.
constexpr double rounding = 4e-4;

TEST_F(OwnShading, TheAnswerIsTheTruthPerPixel) {
    for (const char *name : {"three-point-lights", "spot-light", "directional-light", "box-4-normal-matrix", "vase",
                             "chequered-sphere", "studio"}) {
        const Scene scene = scene_named(name);
        for (const Model model : all_models) {
            const std::string text = own_answer({&scene, name}, {.model = model}, renderer.parts());
            EXPECT_LT(error_of(scene, own(Frequency::per_pixel, text), {.model = model}), rounding)
                << name << " " << text;
        }
    }
}

TEST_F(OwnShading, TheAnswerIsTheProgramsOwnPerVertexAndFlat) {
    for (const char *name :
         {"three-point-lights", "spot-light", "directional-light", "box-4-normal-matrix", "point-light"}) {
        const Scene scene = scene_named(name);
        for (const Model model : {Model::phong, Model::blinn_phong}) {
            for (const Frequency frequency : {Frequency::per_vertex, Frequency::flat}) {
                const std::string text = own_answer({&scene, name}, {.model = model}, renderer.parts());
                const Technique given{.frequency = frequency, .model = model};
                EXPECT_LT(error_of(scene, own(frequency, text), given), rounding) << name << to_string(given);
                const Metrics metrics = compare(renderer.render(scene, own(frequency, text), size, true),
                                                renderer.render(scene, given, size, true));
                EXPECT_LT(metrics.norms.max_abs, rounding) << name << to_string(given);
            }
        }
    }
}

/// A pixel turns N by winding, as for the program's own models; at vertices both sides are lit.
TEST_F(OwnShading, TwoSidedObjectsAreLitOnTheSideThatIsSeen) {
    Scene scene = scene_named("three-point-lights");
    scene.objects.resize(1);
    scene.objects[0].mesh = PlaneShape{{3, 3}, 8};
    scene.objects[0].transform = {{0, 0, 0}, {-100, 20, 0}, {1, 1, 1}}; // its back to the camera
    scene.objects[0].two_sided = true;
    const std::string text = own_answer({&scene, "s"}, {.model = Model::phong}, renderer.parts());
    for (const Frequency frequency : {Frequency::flat, Frequency::per_vertex, Frequency::per_pixel}) {
        const Technique given{.frequency = frequency, .model = Model::phong};
        EXPECT_LT(error_of(scene, own(frequency, text), given), rounding) << to_string(given);
    }
}

/// A file that serves every scene is right on each, too: what a scene lacks is 0 or 1 in the interface.
TEST_F(OwnShading, TheAnswerForAnySceneIsRight) {
    const std::string text = own_answer({}, {.model = Model::phong}, renderer.parts());
    for (const char *name : {"three-point-lights", "spot-light", "vase", "studio"}) {
        EXPECT_LT(error_of(scene_named(name), own(Frequency::per_pixel, text), {.model = Model::phong}), rounding)
            << name;
    }
}

TEST_F(OwnShading, APlainColourNeedsNoUniformAndNoNormal) {
    const Scene scene = scene_named("three-point-lights");
    const auto resources = renderer.resources().load(scene);
    const PreparedObject prepared =
        prepare_objects(scene, own(Frequency::per_pixel, body("return vec3(0.25, 0.5, 0.75);")), resources)[0];
    EXPECT_EQ(prepared.needs.attributes, VertexAttributes{});
    const GlProgram program(assemble(prepared.program, renderer.parts()));
    ASSERT_EQ(program.uniforms().size(), 1U);
    EXPECT_TRUE(program.has("model_view_projection"));
    const Image picture =
        renderer.render(scene, own(Frequency::flat, body("return vec3(0.25, 0.5, 0.75);")), size).color;
    EXPECT_EQ(picture.at(size.width / 2, size.height / 2), glm::vec4(0.25F, 0.5F, 0.75F, 1));
}

/// Own transforms are right where they say what the program does, and are what is lit.
TEST_F(OwnShading, PositionAndNormalReplaceTheProgramsTransforms) {
    Scene scene = scene_named("three-point-lights");
    scene.objects[0].transform = {{0.5, 0.25, 0}, {20, 30, 40}, {1, 0.5, 1.25}};
    const std::string answer = own_answer({&scene, "s"}, {.model = Model::phong}, renderer.parts());
    const std::string transforms = "vec3 position(vec3 p) { return (model_matrix * vec4(p, 1.0)).xyz; }\n"
                                   "vec3 normal(vec3 n) { return normalize(normal_matrix * n); }\n";
    for (const Frequency frequency : {Frequency::flat, Frequency::per_vertex, Frequency::per_pixel}) {
        const Technique given{.frequency = frequency, .model = Model::phong};
        EXPECT_LT(error_of(scene, own(frequency, answer + transforms), given), rounding) << to_string(given);
    }
    std::string wrong = transforms;
    wrong.replace(wrong.find("normal_matrix"), 13, "mat3(model_matrix)");
    EXPECT_GT(error_of(scene, own(Frequency::per_pixel, answer + wrong), {.model = Model::phong}), 0.01);
}

/// 4,096 turns are counted over all loops together, whatever their conditions say, and the picture is drawn.
TEST_F(OwnShading, AnEndlessLoopEndsAndDraws) {
    const Scene scene = scene_named("point-light");
    const auto middle = [&](const std::string &lines) {
        return renderer.render(scene, own(Frequency::per_pixel, body(lines)), {9, 9}).color.at(4, 4);
    };
    const std::string counted = "float n = 0.0;\n{}\nreturn vec3(n);";
    for (const char *loop : {"for (;;) n += 1.0;", "while (true) { n += 1.0; }", "for (;;) for (;;) { n += 1.0; }",
                             "for (int i = 0; i < 10000; ++i) { i = 0; n += 1.0; }"}) {
        const float turns = middle(fmt::format(fmt::runtime(counted), loop)).r;
        EXPECT_LE(turns, 4096) << loop;
        EXPECT_GE(turns, 4095) << loop; // the outer loop's own turn
    }
    EXPECT_EQ(middle(fmt::format(fmt::runtime(counted), "do { n += 1.0; } while (true);")).r, 4097);
    EXPECT_EQ(middle(fmt::format(fmt::runtime(counted), "for (int i = 0; i < 7; ++i) n += 1.0;")).r, 7);
}

TEST_F(OwnShading, TheCompilersErrorsNameTheFileAndItsOwnLine) {
    EXPECT_NE(failure(own(Frequency::per_pixel, body("float a = 1.0;\nreturn no_such;"))).find("own.glsl:4:"),
              std::string::npos)
        << failure(own(Frequency::per_pixel, body("float a = 1.0;\nreturn no_such;")));
    EXPECT_NE(failure(own(Frequency::per_vertex, body("/* a\n comment */\nreturn vec2(0.0);"))).find("own.glsl:5:"),
              std::string::npos);
}

/// In a browser an int is no float. A driver that cannot compile GLSL ES 3.00 cannot tell.
TEST_F(OwnShading, WhatABrowserRefusesIsRefused) {
    const std::string message = failure(own(Frequency::per_pixel, body("float a = 1;\nreturn vec3(a);")));
    if (message.empty()) {
        GTEST_SKIP() << "this driver has no ARB_ES3_compatibility";
    }
    EXPECT_NE(message.find("own.glsl:3:"), std::string::npos) << message;
}

TEST_F(OwnShading, HasNoReference) {
    const Scene scene = scene_named("point-light");
    EXPECT_THROW(render_reference(scene, renderer.resources().load(scene), own(Frequency::per_pixel, body("return P;")),
                                  size, Surface::mesh, {}),
                 InputError);
}

TEST_F(OwnShading, StrangersTextsAreDrawnElsewhereAndTheProgramsOwnHere) {
    const std::string text = "vec3 lighting(vec3 P, vec3 N, vec3 eye) { return vec3(0.5); }";
    const Frame elsewhere{Image(size, glm::vec4(0.25F)), {}, 1};
    renderer.draw_own_by([&](const Scene &, const Technique &, Size, bool) { return elsewhere; });
    Technique technique = own(Frequency::per_pixel, text);
    const Scene scene = scene_named("point-light");
    EXPECT_EQ(renderer.render(scene, technique, size).color.at(80, 60), glm::vec4(0.25F));
    Target target(size);
    renderer.draw(scene, technique, target);
    EXPECT_EQ(target.read_pixel(80, 60), glm::vec4(0.25F));
    ScreenTarget screen(size);
    EXPECT_THROW(renderer.draw_shown(scene, technique, {}, screen), std::logic_error);
    technique.own = OwnShader("own.glsl", text, OwnShader::Author::program);
    EXPECT_EQ(renderer.render(scene, technique, size).color.at(80, 60).x, 0.5F);
}

} // namespace
} // namespace sandbox

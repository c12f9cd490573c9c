#include "shading/rounded_text.h"

#include "scene/scene_file.h"
#include "shading/prepared_object.h"
#include "tools/feature_scenes.h"
#include "tools/technique_walk.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <sstream>
#include <stdexcept>

namespace sandbox {
namespace {

/// A stage with `statement` in its main, and that line as it is written in half.
std::string rounded(const std::string &statement) {
    StageSource stage{"#version 330 core\nin vec3 v_position;\nstruct PointLight {\n    vec3 position;\n};\n"
                      "uniform PointLight the_point_light;\nvoid main()\n{\n    " +
                          statement + "\n}\n",
                      {}};
    stage.origins.assign(12, {"fragment.glsl", 1});
    std::istringstream lines(with_rounded_operations(stage).text);
    std::string line;
    for (int i = 0; i < 9; ++i) {
        std::getline(lines, line);
    }
    return line.substr(4);
}

TEST(RoundedText, RoundsEveryOperation) {
    EXPECT_EQ(rounded("float y = a + b * c;"), "float y = h(a + h(b * c));");
    EXPECT_EQ(rounded("float y = a - b - c;"), "float y = h(h(a - b) - c);");
    EXPECT_EQ(rounded("float y = (a + b) / -c;"), "float y = h(h(a + b) / -c);");
    EXPECT_EQ(rounded("float y = a > b && c < d ? a * b : c;"), "float y = a > b && c < d ? h(a * b) : c;");
    EXPECT_EQ(rounded("return a * b;"), "return h(a * b);");
    EXPECT_EQ(rounded("if (a * b > c) { y = a / b; }"), "if (h(a * b) > c) { y = h(a / b); }");
}

TEST(RoundedText, RoundsWhatIsAddedToAVariable) {
    EXPECT_EQ(rounded("sum += a * b;"), "sum = h(sum + h(a * b));");
    EXPECT_EQ(rounded("s *= a > b ? c : d;"), "s = h(s * (a > b ? c : d));");
}

TEST(RoundedText, RoundsWhatItReads) {
    EXPECT_EQ(rounded("vec3 P = v_position;"), "vec3 P = h(v_position);");
    EXPECT_EQ(rounded("vec3 d = the_point_light.position - v_position.xyz;"),
              "vec3 d = h(h(the_point_light.position) - h(v_position).xyz);");
    EXPECT_EQ(rounded("float y = max(x, 1e-6);"), "float y = max(x, h(1e-6));");
    EXPECT_EQ(rounded("float y = max(x, 0.5);"), "float y = max(x, 0.5);") << "a half already";
}

TEST(RoundedText, TakesFunctionsApart) {
    EXPECT_EQ(rounded("float y = dot(a, b);"), "float y = h_dot(a, b);");
    EXPECT_EQ(rounded("float y = pow(max(dot(a, b), 0.0), n);"), "float y = h_pow(max(h_dot(a, b), 0.0), n);");
    EXPECT_EQ(rounded("float y = exp(x);"), "float y = h(exp(x));");
    EXPECT_THROW(rounded("float y = refract(a, b, c);"), std::logic_error) << "no part of shaders/ uses it";
}

TEST(RoundedText, LeavesDepthAndPixelsHigh) {
    EXPECT_EQ(rounded("gl_FragDepth = a - b * log2(c);"), "gl_FragDepth = a - b * log2(c);");
    EXPECT_EQ(rounded("vec3 P = (a + gl_FragCoord.x * b) / gl_FragCoord.w;"),
              "vec3 P = h((a + gl_FragCoord.x * b) / gl_FragCoord.w);");
}

/// Calls visit(scene, object index, technique with precision=medium, features).
void for_each_medium_program(const auto &visit) {
    Resources resources{Assets("assets")};
    for (const Scene &scene : feature_scenes()) {
        const auto loaded = resources.load(scene);
        for (Technique technique : pairwise_techniques()) {
            technique.precision = Precision::medium;
            if (!why_refused(technique)) {
                for (const DrawOptions &options :
                     {DrawOptions{}, DrawOptions{.object_ids = true, .shown = DisplayMap{}, .deep = true}}) {
                    for (const PreparedObject &object : prepare_objects(scene, technique, loaded, options)) {
                        visit(object.program);
                    }
                }
            }
        }
    }
}

std::size_t lines_of(const std::string &text) { return static_cast<std::size_t>(std::ranges::count(text, '\n')); }

TEST(RoundedText, EveryProgramCanBeRoundedAndKeepsItsLines) {
    const ShaderParts parts(Assets("shaders"));
    std::size_t programs = 0;
    for_each_medium_program([&](const Features &medium) {
        ++programs;
        Features high = medium;
        high.technique.precision = Precision::high;
        const ProgramSource rounded = assemble(medium, parts);
        const ProgramSource plain = assemble(high, parts);
        ASSERT_EQ(rounded.vertex.text, plain.vertex.text);
        ASSERT_EQ(rounded.fragment.origins.size(), lines_of(rounded.fragment.text));
        ASSERT_EQ(plain.fragment.text.find("float h("), std::string::npos) << "not a byte of it without the key";
        ASSERT_NE(rounded.fragment.text, plain.fragment.text);
    });
    EXPECT_GT(programs, 200U);
}

} // namespace
} // namespace sandbox

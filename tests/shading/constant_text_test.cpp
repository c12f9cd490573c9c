#include "shading/constant_text.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>

namespace sandbox {
namespace {

UniformValue value(std::initializer_list<float> numbers) {
    UniformValue result;
    result.count = static_cast<int>(numbers.size());
    std::copy(numbers.begin(), numbers.end(), result.numbers.begin());
    return result;
}

StageSource source(const std::string &text) {
    StageSource result{text, {}};
    for (int line = 1; line <= std::count(text.begin(), text.end(), '\n'); ++line) {
        result.origins.push_back({"part.glsl", line});
    }
    return result;
}

/// The fragment stage alone.
StageSource with_constants(const std::string &text, const UniformValues &values) {
    return with_constants(ProgramSource{source(""), source(text)}, values).fragment;
}

TEST(ConstantText, NumbersAndVectorsAreWrittenInAndKeepTheirComments) {
    const StageSource baked = with_constants(
        "uniform vec3 ambient; // all\nuniform float n;\nuniform mat3 m;\n",
        {{"ambient", value({0.25F, 1, -3e-9F})}, {"n", value({32})}, {"m", value({1, 0, 0, 0, 1, 0, 0, 0, 1})}});
    EXPECT_EQ(baked.text, "const vec3 ambient = vec3(0.25, 1.0, -3e-09); // all\n"
                          "const float n = 32.0;\n"
                          "const mat3 m = mat3(1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0);\n");
}

TEST(ConstantText, AnArrayOfStructsIsWrittenALineAnElementAndLinesKeepTheirOrigins) {
    const StageSource baked = with_constants("struct PointLight {\n"
                                             "    vec3 position; // from the eye\n"
                                             "    float linear;\n"
                                             "};\n"
                                             "uniform PointLight point_lights[2];\n"
                                             "void main() {}\n",
                                             {{"point_lights[0].position", value({1, 2, 3})},
                                              {"point_lights[0].linear", value({0.5F})},
                                              {"point_lights[1].position", value({4, 5, 6})},
                                              {"point_lights[1].linear", value({0})}});
    EXPECT_EQ(baked.text, "struct PointLight {\n"
                          "    vec3 position; // from the eye\n"
                          "    float linear;\n"
                          "};\n"
                          "const PointLight point_lights[2] = PointLight[2](\n"
                          "    PointLight(vec3(1.0, 2.0, 3.0), 0.5),\n"
                          "    PointLight(vec3(4.0, 5.0, 6.0), 0.0));\n"
                          "void main() {}\n");
    ASSERT_EQ(baked.origins.size(), 8U);
    EXPECT_EQ(baked.origins[6].line, 5);
    EXPECT_EQ(baked.origins[7].line, 6);
}

TEST(ConstantText, WhatHasNoFiniteValueStaysAUniform) {
    const std::string text = "uniform sampler2D base_texture;\nuniform uint object_id;\nuniform float far;\n"
                             "uniform float inside;\nuniform vec3 two[2];\n";
    EXPECT_EQ(with_constants(text, {{"far", value({INFINITY})}, {"two[0]", value({1, 1, 1})}}).text, text);
}

/// Nine significant digits name a float32.
TEST(ConstantText, EveryNumberReadsBackAsItWas) {
    for (const float number : {0.1F, 1 / 3.0F, 1e-30F, 3.4e38F, 16777217.0F, -0.0F}) {
        const std::string text = with_constants("uniform float x;\n", {{"x", value({number})}}).text;
        EXPECT_EQ(std::strtof(text.c_str() + text.find('=') + 1, nullptr), number) << text;
        EXPECT_NE(text.find_first_of(".e"), std::string::npos) << text << "an int in GLSL";
    }
}

} // namespace
} // namespace sandbox

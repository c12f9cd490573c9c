#include "shading/own_text.h"

#include "image/error.h"
#include "shading/own_files.h"
#include "shading/own_interface.h"
#include "shading/technique.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <regex>

namespace sandbox {
namespace {

const std::string empty_body = "vec3 lighting(vec3 P, vec3 N, vec3 eye) { return vec3(0.0); }\n";

OwnText read(const std::string &text) { return read_own_text("a.glsl", text); }

/// The message that a text is refused with; empty if it is accepted.
std::string refusal(const std::string &text) {
    try {
        read(text);
        return "";
    } catch (const InputError &error) {
        return error.what();
    }
}

std::string compiled(const OwnText &own) {
    std::string all;
    for (const std::string &line : own.lines) {
        all += line + "\n";
    }
    return all;
}

/// The body of lighting(), in the second line.
std::string with_body(const std::string &body) {
    return "vec3 lighting(vec3 P, vec3 N, vec3 eye) {\n" + body + "\n return vec3(0.0); }\n";
}

TEST(OwnText, RefusesWhatBreaksOutOfItsPlaceWithFileAndLine) {
    const std::pair<std::string, std::string> refused[] = {
        {"#version 300 es\n" + empty_body, "a.glsl:1: #version is not accepted"},
        {"\n\n#extension GL_EXT_gpu_shader4 : enable\n" + empty_body, "a.glsl:3: #extension is not accepted"},
        {empty_body + "#include \"/etc/passwd\"\n", "a.glsl:2: #include is not accepted"},
        {"#ifdef GL_ES\n#endif\n" + empty_body, "a.glsl:1: #ifdef is not accepted"},
        {"#pragma optimize(off)\n" + empty_body, "a.glsl:1: #pragma is not accepted"},
        {"#define f(x) x\n" + empty_body, "a.glsl:1: #define f(...) is not accepted: write a function"},
        {"#define a b\n#define b a\n" + with_body("float a = 1.0;"), "leads to itself"},
        {"uniform vec3 mine;\n" + empty_body, "a.glsl:1: 'uniform' is not accepted"},
        {"layout(location = 3) out vec4 c;\n" + empty_body, "a.glsl:1: 'layout' is not accepted"},
        {with_body("gl_FragDepth = 0.0;"), "a.glsl:2: 'gl_FragDepth' is not accepted"},
        {with_body("discard;"), "a.glsl:2: 'discard' is not accepted"},
        {"void main() {}\n" + empty_body, "a.glsl:1: 'main' is not accepted"},
        {with_body("own_turns = 0;"), "a.glsl:2: the name 'own_turns' is kept for the program"},
        {with_body("float a\\\n = 1.0;"), "a.glsl:2: the character '\\' is not accepted"},
        {with_body("float \xC3\xA9 = 1.0;"), "a.glsl:2: the byte 0xc3 is not accepted outside comments"},
        {"/* never closed\n" + empty_body, "a.glsl:1: a comment that begins here has no end"},
        {empty_body + "}\n", "a.glsl:2: this '}' closes nothing"},
        {"vec3 lighting(vec3 P, vec3 N, vec3 eye) {\n(\n}\n", "a.glsl:3: this '}' closes nothing"},
        {"vec3 lighting(vec3 P, vec3 N, vec3 eye) {\n", "a.glsl:1: this '{' is not closed"},
        {"// nothing\n", "a.glsl: expected a function vec3 lighting(vec3 P, vec3 N, vec3 eye)"},
        {"vec3 lighting(vec3 P) { return P; }\n", "a.glsl:1: expected vec3 lighting(vec3 P, vec3 N, vec3 eye)"},
        {"vec4 position(vec3 p) { return vec4(p, 1.0); }\n" + empty_body, "a.glsl:1: expected vec3 position(vec3 p)"},
    };
    for (const auto &[text, message] : refused) {
        EXPECT_NE(refusal(text).find(message), std::string::npos) << text << "\n" << refusal(text);
    }
    EXPECT_EQ(refusal("// \xE4\xB8\xAD\xE6\x96\x87 \\\n#define PI 3.14\n" + empty_body), "");
}

TEST(OwnText, RefusesRecursionAndCallsThatGrow) {
    EXPECT_NE(refusal("float f(float x);\nfloat f(float x) {\n return f(x); }\n" + empty_body)
                  .find("a.glsl:3: 'f' calls itself"),
              std::string::npos);
    EXPECT_NE(refusal("float g(float x);\nfloat f(float x) { return g(x); }\nfloat g(float x) { return f(x); }\n" +
                      empty_body)
                  .find("recursion is not accepted"),
              std::string::npos);
    EXPECT_EQ(refusal("float f(float x) { return x; }\nfloat f(float x, float y) { return f(x) + y; }\n" + empty_body),
              "")
        << "another number of parameters is another function";
    std::string doubling = "float f0(float x) { return x; }\n";
    for (int i = 1; i < 30; ++i) {
        doubling += fmt::format("float f{0}(float x) {{ return f{1}(x) + f{1}(x); }}\n", i, i - 1);
    }
    EXPECT_NE(refusal(doubling + empty_body).find("and all that it calls are more than"), std::string::npos);
    const std::string loop = "float f(float x) { while (x < 1.0) { x += 1.0; } return x; }\n";
    EXPECT_EQ(refusal(loop + with_body("for (;;) for (;;) for (;;) for (;;) for (;;) for (;;) for (;;) f(P.x);")), "");
    EXPECT_NE(refusal(loop + with_body("for (;;) f(f(f(f(f(f(f(f(P.x))))))));"))
                  .find("a.glsl:2: 'lighting' and all that it calls have more than 8 loops"),
              std::string::npos);
    std::string defines = "#define d0 1.0\n";
    for (int i = 1; i < 16; ++i) {
        defines += fmt::format("#define d{0} d{1} + d{1} + d{1}\n", i, i - 1);
    }
    EXPECT_NE(refusal(defines + with_body("float a = d15;")).find("more than 8192 words and symbols"),
              std::string::npos);
}

TEST(OwnText, BoundsItsSizes) {
    const std::string many(most_own_bytes, ' ');
    EXPECT_NE(refusal(many + empty_body).find("expected at most 65536 bytes"), std::string::npos);
    std::string deep = "1.0";
    for (int i = 0; i < deepest_own_nesting; ++i) {
        deep.insert(0, "(").append(")");
    }
    EXPECT_NE(refusal(with_body("float a = " + deep + ";")).find("brackets more than 64 deep"), std::string::npos);
    std::string sum = "1.0";
    for (int i = 0; i < 300; ++i) {
        sum += "+1.0";
    }
    EXPECT_NE(refusal(with_body("float a = " + sum + ";")).find("a statement of more than 512"), std::string::npos);
    const std::string length = "the length of an array: expected a number from 1 to 256, or light_count";
    for (const char *array :
         {"float a[257];", "float a[16*1024];", "const int n = 9999; float a[n];", "float[9999] a;",
          "float a[2], b[9999];", "for (int i = 0, j[999]; i < 1; ++i) {}", "const highp vec4 a[0x7fffff];"}) {
        EXPECT_NE(refusal(with_body(array)).find(length), std::string::npos) << array << refusal(with_body(array));
    }
    EXPECT_NE(refusal("float f(float a[999]) { return a[0]; }\n" + empty_body).find(length), std::string::npos);
    EXPECT_NE(refusal(with_body("mat4 a[32], b[32], c[1];")).find("arrays of more than 1024"), std::string::npos);
    EXPECT_EQ(refusal(with_body("mat4 a[32], b[32];")), "");
    EXPECT_EQ(refusal(with_body("vec4 a[128]; float b[256], c[256];")), "");
    EXPECT_NE(refusal("struct A { float a[9]; };\n" + empty_body).find("inside a struct is not accepted"),
              std::string::npos);
    EXPECT_EQ(refusal(with_body("float a[4]; float b[light_count]; int i = 3; a[i * 1 + 0] = a[i], a[i];")), "");
}

TEST(OwnText, EveryLoopAsksTheBudget) {
    const OwnText own = read(with_body("for (int i = 0; i < 3; ++i) { while (true) {} }\n"
                                       "for (;;) do ; while (false);"));
    EXPECT_TRUE(own.loops);
    EXPECT_EQ(own.lines[1], "for (int i = 0; own_turn() && (i < 3); ++i) { while (own_turn() && (true)) {} }");
    EXPECT_EQ(own.lines[2], "for (;own_turn();) do ; while (own_turn() && (false));");
    EXPECT_EQ(read("#define again while\n" + with_body("again(true);")).lines[2], "while(own_turn() && (true));");
    EXPECT_NE(refusal(with_body("while (bool b = true) {}")).find("a declaration as the condition"), std::string::npos);
    EXPECT_NE(refusal(with_body("for (int i = 0; i < 3) {}")).find("a.glsl:2: expected for ("), std::string::npos);
    EXPECT_FALSE(read(empty_body).loops);
}

TEST(OwnText, LinesStayWhereTheyWereAndCommentsGo) {
    const OwnText own = read("/* one\n two */ float f() { return 1.0; } // three\n\n" + empty_body);
    ASSERT_EQ(own.lines.size(), 5U);
    EXPECT_EQ(own.lines[0], "");
    EXPECT_EQ(own.lines[1], "        float f() { return 1.0; }");
    EXPECT_EQ(own.lines[3] + "\n", empty_body);
    EXPECT_EQ(compiled(own).find('#'), std::string::npos);
}

TEST(OwnText, DeclaresOnlyWhatItNames) {
    const auto declared = [](const std::string &body, int lights) {
        std::string all;
        for (const std::string &line : own_declarations(read(with_body(body)), lights)) {
            all += line + "\n";
        }
        return all;
    };
    EXPECT_EQ(declared("", 3), "");
    EXPECT_EQ(declared("vec3 a = lights[0].color * lights[1].exponent;", 2),
              "struct Light {\n    vec3 color;\n    float exponent;\n};\nuniform Light lights[2];\n");
    EXPECT_EQ(declared("float a = material.shininess; mat3 m = normal_matrix;", 0),
              "struct Material {\n    float shininess;\n};\nuniform Material material;\nuniform mat3 normal_matrix;\n");
    EXPECT_EQ(declared("int a = light_count; bool b = a == SPOT;", 0),
              "const int SPOT = 2;\nconst int light_count = 0;\n");
    const OwnText own = read("vec3 lighting(vec3 P, vec3 normal, vec3 eye) { return normal; }");
    EXPECT_FALSE(own.reads_P);
    EXPECT_TRUE(own.reads_N);
    EXPECT_FALSE(own.reads_eye);
    EXPECT_FALSE(own.normal) << "a parameter of that name is no function";
}

TEST(OwnText, StarterAndAnswersAreAccepted) {
    const ShaderParts parts{Assets("shaders")};
    EXPECT_EQ(refusal(own_starter({}, {}, parts)), "");
    for (const Model model : all_models) {
        EXPECT_EQ(refusal(own_answer({}, {.model = model}, parts)), "") << own_answer({}, {.model = model}, parts);
    }
    const std::string starter = own_starter({}, {}, parts);
    for (const auto &field : own_light_fields()) {
        EXPECT_NE(starter.find(fmt::format("{} {};", field.type, field.name)), std::string::npos) << field.name;
    }
}

TEST(OwnTechnique, NeedsATextAndTakesNoKeys) {
    const auto why = [](const std::string &technique, const OwnShader &own) -> std::string {
        try {
            parse_technique_with(own, technique);
            return "";
        } catch (const InputError &error) {
            return error.what();
        }
    };
    const OwnShader own("a.glsl", empty_body);
    EXPECT_NE(why("per-pixel/own", {}).find("needs a text, which --own FILE.glsl names"), std::string::npos);
    for (const char *taken : {"flat/own", "per-vertex/own", "per-pixel/own"}) {
        EXPECT_EQ(why(taken, own), "");
    }
    EXPECT_NE(why("hybrid/own", own).find("is for flat, per-vertex and per-pixel"), std::string::npos);
    EXPECT_NE(why("interpolated-vectors/own", own).find("is for flat"), std::string::npos);
    for (const char *refused : {"per-pixel/own:program=full", "per-pixel/own:gate=none", "flat/own:power=stable"}) {
        EXPECT_NE(why(refused, own).find("has no meaning beside the model own"), std::string::npos) << refused;
    }
    Technique technique = parse_technique_with(own, "per-pixel/own");
    EXPECT_EQ(parse_technique_with(technique.own, to_string(technique)), technique);
    EXPECT_NE(technique, parse_technique_with(OwnShader("a.glsl", empty_body + " "), "per-pixel/own"));
    technique.own = {};
    EXPECT_EQ(nearest_valid(technique).model, Model::lambert) << "where nothing can draw it";
}

} // namespace
} // namespace sandbox

#include "shading/template.h"

#include "tools/temporary_folder.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace sandbox {
namespace {

class Template : public testing::Test {
  protected:
    /// Expands `text` as the part a.glsl, with flags on, off and kind.on, and the text name.
    StageSource expand_text(const std::string &text, const std::string &other = "") {
        folder_.write("a.glsl", text);
        folder_.write("b.glsl", other);
        const ShaderParts parts(Assets("shaders", folder_.path()));
        const TemplateValues values{.flags = {{"on", true}, {"off", false}, {"kind.on", true}, {"other.on", false}},
                                    .texts = {{"name", "value"}},
                                    .lists = {{"light", {"kind", "other"}}},
                                    .choices = {"chosen", "kind.chosen", "other.chosen"}};
        return expand(parts, "a.glsl", values);
    }
    TemporaryFolder folder_;
};

TEST_F(Template, KeepsAndDropsLines) {
    EXPECT_EQ(expand_text("a\n#if on\nb\n#else\nc\n#endif\nd\n").text, "a\nb\nd\n");
    EXPECT_EQ(expand_text("#if off\nb\n#elif on\nc\n#elif on\nd\n#else\ne\n#endif\n").text, "c\n");
    EXPECT_EQ(expand_text("#if off\n#if on\nb\n#else\nc\n#endif\n#endif\nd\n").text, "d\n");
}

TEST_F(Template, AndBindsTighterThanOr) {
    EXPECT_EQ(expand_text("#if off && off || on\nyes\n#endif\n").text, "yes\n");
    EXPECT_EQ(expand_text("#if on || off && off\nyes\n#endif\n").text, "yes\n");
    EXPECT_EQ(expand_text("#if !on || off\nyes\n#endif\n").text, "");
    EXPECT_EQ(expand_text("#if !off && on\nyes\n#endif\n").text, "yes\n");
}

TEST_F(Template, ReplacesTextsAndIncludesPartsForAKind) {
    EXPECT_EQ(expand_text("int ${name}_${name};\n").text, "int value_value;\n");
    EXPECT_EQ(expand_text("#each light\n#include \"b.glsl\"\n#end\n", "#if light.on\nyes\n#endif\n").text, "yes\n");
}

TEST_F(Template, AChoiceBecomesABranchOnAUniform) {
    EXPECT_EQ(expand_text("#choices\n#if chosen\na;\n#elif off\nb;\n#elif on\nc;\n#else\nd;\n#endif\n").text,
              "uniform bool chosen;\nif (chosen) {\n    a;\n} else {\n    c;\n}\n");
    EXPECT_EQ(expand_text("#if on || chosen\na;\n#endif\n").text, "a;\n");
    EXPECT_EQ(expand_text("#if off && chosen\na;\n#elif on && !chosen\nb;\n#endif\n").text,
              "if (!chosen) {\n    b;\n}\n");
    EXPECT_EQ(expand_text("#each light\n#if light.chosen || chosen\na;\n#endif\n#end\n").text,
              "if (kind_chosen || chosen) {\n    a;\n}\nif (other_chosen || chosen) {\n    a;\n}\n");
}

TEST_F(Template, WhatSeveralBranchesDeclareIsDeclaredBeforeThem) {
    EXPECT_EQ(expand_text("#if chosen\n  float a = 1.0;\n  vec3 own = v;\n#else\n  float a = 2.0;\n#endif\n").text,
              "  float a;\n  if (chosen) {\n      a = 1.0;\n      vec3 own = v;\n  } else {\n      a = 2.0;\n  }\n");
}

TEST_F(Template, RunsOfBlankLinesBecomeOneAndNoneLeads) { EXPECT_EQ(expand_text("\n\na\n\n\n\nb\n").text, "a\n\nb\n"); }

TEST_F(Template, EveryLineKnowsItsOrigin) {
    const StageSource source = expand_text("a\n#if on\n#include \"b.glsl\"\n#endif\nc\n", "x\n\ny\n");
    ASSERT_EQ(source.text, "a\nx\n\ny\nc\n");
    ASSERT_EQ(source.origins.size(), 5U);
    EXPECT_EQ(source.origins[3].part, "b.glsl");
    EXPECT_EQ(source.origins[3].line, 3);
    EXPECT_EQ(source.origins[4].part, "a.glsl");
    EXPECT_EQ(source.origins[4].line, 5);
}

TEST_F(Template, UnknownNamesAndUnbalancedDirectivesAreErrorsWithTheirPlace) {
    const auto message = [&](const std::string &text) {
        try {
            expand_text(text);
        } catch (const std::logic_error &error) {
            return std::string(error.what());
        }
        return std::string("no error");
    };
    EXPECT_EQ(message("a\n#if typo\n#endif\n"), "a.glsl:2: no flag 'typo'");
    EXPECT_EQ(message("#if off\n#if typo\n#endif\n#endif\n"), "a.glsl:2: no flag 'typo'");
    EXPECT_EQ(message("a ${typo}\n"), "a.glsl:1: no text 'typo'");
    EXPECT_EQ(message("a\n#endif\n"), "a.glsl:2: no #if before this");
    EXPECT_EQ(message("#if on\n"), "a.glsl: #if without #endif");
    EXPECT_EQ(message("#include \"a.glsl\"\n"), "a.glsl: parts include each other");
}

TEST(MapLog, KnowsTheCompilersFormats) {
    const StageSource source{"a\nb\n", {{"first.glsl", 7}, {"second.glsl", 31}}};
    EXPECT_EQ(map_log("0:2(5): error: no x\n", source), "second.glsl:31: error: no x\n");
    EXPECT_EQ(map_log("0(2) : error C1503: no x\n", source), "second.glsl:31: error C1503: no x\n");
    EXPECT_EQ(map_log("ERROR: 0:1: no x\n", source), "ERROR: first.glsl:7: no x\n");
    EXPECT_EQ(map_log("0:9(5): error\nplain\n", source), "0:9(5): error\nplain\n");
}

} // namespace
} // namespace sandbox

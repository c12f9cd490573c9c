#include "commands/gl_command_test.h"

#include <nlohmann/json.hpp>

/// Own shading through the commands that draw.
namespace sandbox {
namespace {

class OwnGl : public GlCommandTest {
  protected:
    void SetUp() override {
        GlCommandTest::SetUp();
        folder.write("red.glsl", "vec3 lighting(vec3 P, vec3 N, vec3 eye) { return vec3(1.0, 0.0, 0.0); }\n");
        folder.write("error.glsl", "vec3 lighting(vec3 P, vec3 N, vec3 eye)\n{\n    return nothing;\n}\n");
    }
    [[nodiscard]] Arguments with_size(Arguments arguments) const {
        arguments.insert(arguments.end(), {"--size", "160x120"});
        return arguments;
    }
};

TEST_F(OwnGl, TheAnswerIsTheTruth) {
    ASSERT_EQ(run_sandbox({"own", "three-point-lights", "--answer", "--technique", "per-pixel/phong", "--out",
                           folder.file("answer.glsl")})
                  .exit_code,
              0);
    const ProcessResult result = run_sandbox(
        with_size({"compare", "three-point-lights", "--left", "per-pixel/own", "--own-left", folder.file("answer.glsl"),
                   "--right", "reference:model=phong", "--json", "--max-abs", "0.0004"})); // float32's pow()
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const auto figures = nlohmann::json::parse(result.out);
    EXPECT_GT(figures["compared_pixels"], 1000);
    EXPECT_EQ(figures["left"], "per-pixel/own");
}

TEST_F(OwnGl, AReferenceOfOwnShadingNeedsAModel) {
    const ProcessResult result = run_sandbox(with_size({"compare", "point-light", "--left", "per-pixel/own", "--own",
                                                        folder.file("red.glsl"), "--right", "reference"}));
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_NE(result.err.find("--right: own shading has no reference: name the model"), std::string::npos)
        << result.err;
}

/// Each turn is worth 300 calls of sin(): the loop's budget alone would let a small picture take minutes.
TEST_F(OwnGl, WhatTakesTooLongIsRefused) {
    std::string text = "vec3 lighting(vec3 P, vec3 N, vec3 eye)\n{\n    float x = P.x;\n    for (;;) {\n";
    for (int i = 0; i < 300; ++i) {
        text += "        x = sin(x + 0.1);\n";
    }
    folder.write("slow.glsl", text + "    }\n    return vec3(x);\n}\n");
    const ProcessResult result =
        run_sandbox(with_size({"capture", "point-light", "--technique", "per-pixel/own", "--own",
                               folder.file("slow.glsl"), "--out", folder.file("slow.png")}));
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_NE(result.err.find("slow.glsl: took more than 5 s of processor time to compile and draw"), std::string::npos)
        << result.err;
    EXPECT_EQ(folder.read("slow.png"), "");
}

/// A picture of several samples is of cameras that no scene file can hold.
TEST_F(OwnGl, SamplesReachTheProcessThatDrawsThem) {
    const auto picture = [&](const char *samples, const char *name) {
        EXPECT_EQ(run_sandbox(with_size({"capture", "point-light", "--technique", "per-pixel/own", "--own",
                                         folder.file("red.glsl"), "--samples", samples, "--out", folder.file(name)}))
                      .exit_code,
                  0);
        return folder.read(name);
    };
    EXPECT_NE(picture("1", "one.png"), picture("4", "four.png"));
}

TEST_F(OwnGl, TheServerIsNotStartedByHand) {
    const ProcessResult result = run_sandbox({"own-server"}, {}, "< /dev/null");
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(run_sandbox({"--help"}).out.find("own-server"), std::string::npos);
}

TEST_F(OwnGl, ASidecarHoldsTheText) {
    const Arguments pair{"--left",          "per-vertex/own", "--right",
                         "per-pixel/phong", "--own-left",     folder.file("red.glsl")};
    Arguments arguments = with_size({"capture", "point-light", "--out", folder.file("a.png")});
    arguments.insert(arguments.end(), pair.begin(), pair.end());
    ASSERT_EQ(run_sandbox(arguments).exit_code, 0);
    folder.write("red.glsl", "");
    const ProcessResult again = run_sandbox({"capture", folder.file("a.png.json"), "--out", folder.file("b.png")});
    EXPECT_EQ(again.exit_code, 0) << again.err;
    EXPECT_FALSE(folder.read("a.png").empty());
    EXPECT_EQ(folder.read("a.png"), folder.read("b.png"));
}

TEST_F(OwnGl, ACompilersErrorIsBadInputAndNamesTheLine) {
    const ProcessResult result = run_sandbox(with_size(
        {"time", "point-light", "--frames", "1", "--technique", "per-pixel/own", "--own", folder.file("error.glsl")}));
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_NE(result.err.find("error.glsl:3:"), std::string::npos) << result.err;
}

} // namespace
} // namespace sandbox

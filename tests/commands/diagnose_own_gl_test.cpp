#include "commands/gl_command_test.h"

#include <algorithm>
#include <nlohmann/json.hpp>

/// `diagnose --own`: files of own shading held against the truth.
namespace sandbox {
namespace {

class DiagnoseOwnGl : public GlCommandTest {
  protected:
    /// The textbook's file for a scene with `from` written as `to`.
    [[nodiscard]] std::string answer(const std::string &scene, const std::string &from = "",
                                     const std::string &to = "") const {
        std::string text = run_sandbox({"own", scene, "--answer", "--technique", "per-pixel/phong"}).out;
        const auto place = text.find(from);
        EXPECT_NE(place, std::string::npos) << from;
        folder.write("own.glsl", text.replace(place, from.size(), to));
        return folder.file("own.glsl");
    }
    static nlohmann::json diagnosed(const std::string &scene, const std::string &file, int exit_code,
                                    const Arguments &more = {}) {
        Arguments arguments{"diagnose", scene, "--own", file, "--json"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        if (std::ranges::find(more, "--size") == more.end()) {
            arguments.insert(arguments.end(), {"--size", "160x120"});
        }
        const ProcessResult result = run_sandbox(arguments);
        EXPECT_EQ(result.exit_code, exit_code) << result.err;
        return nlohmann::json::parse(result.out);
    }
    static std::vector<std::string> remaining(const nlohmann::json &json) {
        return json["after_proposal"]["remaining"];
    }
};

TEST_F(DiagnoseOwnGl, TheAnswerIsRightAndStaysRightInTheProposedScene) {
    const auto json = diagnosed("vase", answer("vase"), 0);
    EXPECT_EQ(json["verdict"], "right");
    EXPECT_EQ(json["technique"], "per-pixel/phong");
    EXPECT_LT(json["residual"], 0.2); // float32's pow()
    ASSERT_FALSE(json["proposal"].is_null());
    EXPECT_EQ(std::ranges::count(remaining(json), "per-pixel/phong"), 1);
    for (const std::string told : json["proposal"]["tells"]) {
        EXPECT_EQ(std::ranges::count(remaining(json), told), 0) << told;
    }
}

TEST_F(DiagnoseOwnGl, AFaultThatTheSceneHidesIsFoundInTheProposedOne) {
    const std::string file = answer("vase", "n_dot_l > 0.0", "dot(N, V) > 0.0");
    const auto json = diagnosed("vase", file, 0, {"--technique", "per-pixel/phong"});
    EXPECT_EQ(json["verdict"], "right");
    EXPECT_EQ(std::ranges::count(remaining(json), "per-pixel/phong:gate=view-facing"), 1);
    EXPECT_EQ(std::ranges::count(remaining(json), "per-pixel/phong"), 0);
    const ProcessResult text = run_sandbox({"diagnose", "vase", "--own", file, "--size", "160x120"});
    EXPECT_NE(text.out.find("It has a fault, which this scene does not show."), std::string::npos) << text.out;
}

/// pow() of float32 errs by n times the rounding of its cosine: some levels at these exponents.
TEST_F(DiagnoseOwnGl, TheTextbooksPowIsRightInStiffHighlights) {
    for (const char *shininess : {"1000", "10000", "100000"}) {
        const std::string setting = std::string("objects[0].material.shininess=") + shininess;
        const std::string file = answer("point-light");
        const Arguments stiff{"--technique", "per-pixel/phong", "--set", setting, "--size", "640x480"};
        EXPECT_EQ(diagnosed("point-light", file, 0, stiff)["verdict"], "right") << shininess;
    }
}

TEST_F(DiagnoseOwnGl, AFaultIsNamed) {
    const std::string file = answer("three-point-lights", "pow(f, n)", "pow(f, n) * n_dot_l");
    const auto json = diagnosed("three-point-lights", file, 1);
    EXPECT_EQ(json["technique"], "per-pixel/phong:gate=times-n-dot-l");
    EXPECT_TRUE(json["conventions"].empty());
}

TEST_F(DiagnoseOwnGl, TheFrequencyOfTheTechniqueIsWhereItIsDrawn) {
    const std::string file = answer("three-point-lights");
    for (const char *technique : {"per-vertex/own", "per-vertex/phong"}) {
        EXPECT_EQ(diagnosed("three-point-lights", file, 0, {"--technique", technique})["technique"],
                  "per-vertex/phong");
    }
    const ProcessResult result =
        run_sandbox({"diagnose", "three-point-lights", "--own", file, "--technique", "hybrid/phong"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_NE(result.err.find("--technique: "), std::string::npos) << result.err;
}

TEST_F(DiagnoseOwnGl, WhatDoesNotCompileIsBadInput) {
    folder.write("error.glsl", "vec3 lighting(vec3 P, vec3 N, vec3 eye)\n{\n    return nothing;\n}\n");
    const ProcessResult result = run_sandbox({"diagnose", "point-light", "--own", folder.file("error.glsl")});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find("error.glsl:3:"), std::string::npos) << result.err;
}

} // namespace
} // namespace sandbox

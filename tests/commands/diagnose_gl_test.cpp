#include "commands/gl_command_test.h"

#include <nlohmann/json.hpp>

/// `diagnose` of the built program, on pictures that it captured itself.
namespace sandbox {
namespace {

class DiagnoseGl : public GlCommandTest {
  protected:
    std::string captured(const std::string &scene, const std::string &technique, const Arguments &more = {}) const {
        const std::string file = folder.file("a.png");
        Arguments arguments{"capture", scene,          "--technique", technique, "--size",
                            "160x120", "--no-sidecar", "--out",       file};
        arguments.insert(arguments.end(), more.begin(), more.end());
        EXPECT_EQ(run_sandbox(arguments).exit_code, 0);
        return file;
    }
    static nlohmann::json diagnosed(const std::string &scene, const std::string &file, int exit_code,
                                    const std::string &technique = "per-pixel/phong") {
        const ProcessResult result = run_sandbox({"diagnose", scene, file, "--json", "--technique", technique});
        EXPECT_EQ(result.exit_code, exit_code) << result.err;
        return nlohmann::json::parse(result.out);
    }
};

TEST_F(DiagnoseGl, ARightPictureExitsWithZero) {
    const auto json = diagnosed("point-light", captured("point-light", "per-pixel/phong"), 0);
    EXPECT_EQ(json["verdict"], "right");
    EXPECT_EQ(json["technique"], "per-pixel/phong");
    EXPECT_EQ(json["residual"], 0);
    EXPECT_TRUE(json["conventions"].empty());
}

TEST_F(DiagnoseGl, AFaultIsNamedWithItsPixelAndExitsWithOne) {
    const std::string file = captured("three-point-lights", "per-pixel/phong:gate=times-n-dot-l");
    const auto json = diagnosed("three-point-lights", file, 1);
    EXPECT_EQ(json["verdict"], "named");
    EXPECT_EQ(json["technique"], "per-pixel/phong:gate=times-n-dot-l");
    EXPECT_TRUE(json["ties"].empty());
    EXPECT_NE(json["pixel"]["expected"], json["pixel"]["right"]);
    EXPECT_EQ(json["pixel"]["expected"], json["pixel"]["picture"]);
    const ProcessResult text = run_sandbox({"diagnose", "three-point-lights", file, "--out", folder.file("r.png")});
    EXPECT_EQ(text.exit_code, 1);
    EXPECT_NE(text.out.find("gate=times-n-dot-l: times N.L"), std::string::npos) << text.out;
    EXPECT_FALSE(folder.read("r.png").empty());
}

TEST_F(DiagnoseGl, ConventionsAreNamed) {
    const auto conventions = [&](const Arguments &more) {
        const auto json = diagnosed("three-point-lights", captured("three-point-lights", "per-pixel/phong", more), 1);
        EXPECT_EQ(json["technique"], "per-pixel/phong") << json.dump(2);
        return json["conventions"].dump();
    };
    EXPECT_EQ(conventions({"--display", "srgb"}), R"(["display=srgb"])");
    EXPECT_EQ(conventions({"--exposure", "0.7"}), R"(["factor=0.7"])");
    EXPECT_EQ(conventions({"--set", "lights[1].color=[0,0,0]"}), R"(["lights[1]=0"])");
    EXPECT_EQ(conventions({"--set", "lights[0].attenuation={}", "--set", "lights[1].attenuation={}", "--set",
                           "lights[2].attenuation={}"}),
              R"(["attenuation=none"])");
}

/// Of every object: the scene's are 48 and 24.
TEST_F(DiagnoseGl, OtherExponentsAreNamed) {
    const std::string file =
        captured("point-light", "per-pixel/phong",
                 {"--set", "objects[0].material.shininess=24", "--set", "objects[1].material.shininess=12"});
    const auto json = diagnosed("point-light", file, 1);
    EXPECT_EQ(json["technique"], "per-pixel/phong");
    EXPECT_EQ(json["conventions"].dump(), R"(["exponent=0.5"])");
}

TEST_F(DiagnoseGl, TwoFaultsAreNamedWhereOneIsNotEnough) {
    const std::string truth = "per-pixel/phong:position=w0,gate=times-n-dot-l";
    const auto json = diagnosed("three-point-lights", captured("three-point-lights", truth), 1);
    EXPECT_EQ(json["technique"], truth);
}

TEST_F(DiagnoseGl, APictureOfAnotherSceneIsUnknown) {
    const auto json = diagnosed("point-light", captured("studio", "per-pixel/phong"), 1);
    EXPECT_EQ(json["verdict"], "unknown");
    EXPECT_TRUE(json["technique"].is_null());
    EXPECT_GT(json["residual"], 10);
}

TEST_F(DiagnoseGl, PicturesInDoubleAreComparedBesideEdges) {
    const std::string file = folder.file("truth.pfm");
    ASSERT_EQ(run_sandbox({"reference", "three-point-lights", "--technique", "per-pixel/phong:viewer=infinite",
                           "--size", "160x120", "--out", file})
                  .exit_code,
              0);
    EXPECT_EQ(diagnosed("three-point-lights", file, 1)["technique"], "per-pixel/phong:viewer=infinite");
}

} // namespace
} // namespace sandbox

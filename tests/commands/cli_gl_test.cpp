#include "commands/gl_command_test.h"

#include <nlohmann/json.hpp>
#include <sstream>

/// The built program's commands that draw.
namespace sandbox {
namespace {

class CliGl : public GlCommandTest {
  protected:
    /// capture point-light --out <folder>/name --size 64x48 ...
    [[nodiscard]] ProcessResult capture(const std::string &name, Arguments more = {}) const {
        more.insert(more.begin(), {"capture", "point-light", "--out", folder.file(name), "--size", "64x48"});
        return run_sandbox(more);
    }
    [[nodiscard]] bool same_bytes(const std::string &a, const std::string &b) const {
        return !folder.read(a).empty() && folder.read(a) == folder.read(b);
    }
};

TEST_F(CliGl, CaptureWritesAPictureAndItsSidecar) {
    const ProcessResult result = capture("a.png");
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out + result.err, "");
    EXPECT_EQ(folder.names(), (Arguments{"a.png", "a.png.json"}));
    const auto sidecar = nlohmann::json::parse(folder.read("a.png.json"));
    EXPECT_EQ(sidecar["techniques"], nlohmann::json::array({"per-pixel/blinn-phong"}));
    EXPECT_EQ(sidecar["size"], nlohmann::json::array({64, 48}));
    EXPECT_EQ(sidecar["version"], SANDBOX_VERSION);
    EXPECT_FALSE(sidecar["renderer"].get<std::string>().empty());
    EXPECT_TRUE(sidecar["scene"].is_object());
    EXPECT_EQ(capture("b.png", {"--no-sidecar"}).exit_code, 0);
    EXPECT_EQ(folder.names(), (Arguments{"a.png", "a.png.json", "b.png"}));
}

TEST_F(CliGl, ASidecarMakesThePictureAgainBitForBit) {
    const Arguments two{"--left", "per-vertex/phong", "--right", "per-pixel/phong:gate=none"};
    const auto with = [&](Arguments more) {
        more.insert(more.end(), two.begin(), two.end());
        return more;
    };
    const std::vector<std::pair<std::string, Arguments>> pictures{
        {"plain.png", {"--set", "lights[0].diffuse=0.1234567890123"}},
        {"one.png", {"--technique", "flat/lambert", "--display", "srgb", "--exposure", "1.7", "--labels"}},
        {"sides.png", with({"--labels"})},
        {"wipe.png", with({"--layout", "wipe"})},
        {"difference.png", with({"--layout", "difference", "--gain", "3.3", "--labels"})},
        {"of-truth.png", with({"--layout", "difference", "--difference-of", "b-reference"})},
        {"marks.png", with({"--pixel", "0.4,0.6", "--vectors", "--loupe", "--profile-at", "0.3", "--labels"})},
        {"lines.png", with({"--layout", "three-up", "--wireframe", "--labels"})},
        {"overlays.png", with({"--normals", "--vertices", "--lights", "--labels"})},
        {"samples.png", with({"--layout", "three-up", "--samples", "4"})},
        {"difference.pfm", with({"--layout", "difference"})}};
    for (const auto &[name, flags] : pictures) {
        ASSERT_EQ(capture(name, flags).exit_code, 0) << name;
        const std::string again = "again-" + name;
        const ProcessResult result = run_sandbox({"capture", folder.file(name + ".json"), "--out", folder.file(again)});
        EXPECT_EQ(result.exit_code, 0) << name << result.err;
        EXPECT_TRUE(same_bytes(name, again)) << name;
        EXPECT_TRUE(same_bytes(name + ".json", again + ".json")) << name;
    }
}

/// A flattened object: a textbook inverts its matrix, no program here does.
TEST_F(CliGl, ASidecarBringsATextbooksPictureBack) {
    const auto draw = [&](const std::string &name, Arguments more) {
        more.insert(more.begin(), {"capture", folder.file("a.png.json"), "--out", folder.file(name)});
        const ProcessResult result = run_sandbox(more);
        EXPECT_EQ(result.exit_code, 0) << result.err;
    };
    ASSERT_EQ(capture("a.png", {"--set", "objects[0].transform.scale=[1,0,1]"}).exit_code, 0);
    auto sidecar = nlohmann::json::parse(folder.read("a.png.json"));
    sidecar["textbook_left"] = true;
    folder.write("a.png.json", sidecar.dump());
    draw("textbook.png", {});
    draw("again.png", {"--technique", "per-pixel/blinn-phong"});
    EXPECT_FALSE(same_bytes("a.png", "textbook.png"));
    EXPECT_TRUE(nlohmann::json::parse(folder.read("textbook.png.json"))["textbook_left"]);
    EXPECT_TRUE(same_bytes("a.png", "again.png")); // a technique that is named is drawn by its program
}

TEST_F(CliGl, FlagsOverrideASidecar) {
    ASSERT_EQ(capture("two.png", {"--left", "flat/phong", "--right", "flat/lambert", "--labels"}).exit_code, 0);
    ASSERT_EQ(capture("one.png", {"--technique", "flat/lambert"}).exit_code, 0);
    const ProcessResult result = run_sandbox({"capture", folder.file("two.png.json"), "--out", folder.file("b.png"),
                                              "--technique", "flat/lambert", "--no-labels"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_TRUE(same_bytes("one.png", "b.png"));
}

TEST_F(CliGl, TurntableFramesAreNumberedAndHaveOneSidecar) {
    ASSERT_EQ(capture("turn_%03d.png", {"--frames", "3", "--orbit", "360"}).exit_code, 0);
    EXPECT_EQ(folder.names(), (Arguments{"turn_%03d.png.json", "turn_000.png", "turn_001.png", "turn_002.png"}));
    ASSERT_EQ(capture("still.png").exit_code, 0);
    EXPECT_TRUE(same_bytes("turn_000.png", "still.png"));
    EXPECT_FALSE(same_bytes("turn_001.png", "turn_000.png"));
    const auto again = [&](const std::string &out, Arguments more = {}) {
        more.insert(more.begin(), {"capture", folder.file("turn_%03d.png.json"), "--out", folder.file(out)});
        return run_sandbox(more);
    };
    EXPECT_EQ(again("again_%d.png").exit_code, 0);
    for (const char *frame : {"0", "1", "2"}) {
        EXPECT_TRUE(same_bytes(std::string("turn_00") + frame + ".png", std::string("again_") + frame + ".png"));
    }
    EXPECT_TRUE(same_bytes("turn_%03d.png.json", "again_%d.png.json"));
    EXPECT_EQ(again("first.png").exit_code, 0) << "one picture of it is the first";
    EXPECT_TRUE(same_bytes("turn_000.png", "first.png"));
    EXPECT_EQ(again("half_%d.png", {"--orbit", "720"}).exit_code, 0);
    EXPECT_FALSE(same_bytes("turn_001.png", "half_1.png"));
}

TEST_F(CliGl, MarksAreDrawnOrRefused) {
    ASSERT_EQ(capture("plain.png").exit_code, 0);
    const std::vector<Arguments> marks{
        {"--profile-at", "0.5"}, {"--pixel", "0.5,0.5", "--vectors"}, {"--pixel", "0.5,0.5", "--loupe"}};
    for (const Arguments &flags : marks) {
        EXPECT_EQ(capture("marked.png", flags).exit_code, 0);
        EXPECT_FALSE(same_bytes("plain.png", "marked.png")) << flags.back();
    }
    const std::vector<std::pair<Arguments, std::string>> refused{
        {{"--vectors"}, "--vectors needs --pixel"},
        {{"--pixel", "0.5", "--loupe"}, "--pixel: expected a share"},
        {{"--pixel", "0.5,1.5", "--loupe"}, "--pixel: expected a share of the view from 0 to 1, got '1.5'"},
        {{"--profile-at", "nan"}, "--profile-at: expected a share"}};
    for (const auto &[flags, why] : refused) {
        const ProcessResult wrong = capture("wrong.png", flags);
        EXPECT_EQ(wrong.exit_code, 2);
        EXPECT_NE(wrong.err.find(why), std::string::npos) << wrong.err;
    }
    EXPECT_EQ(capture("a.pfm", {"--profile-at", "0.5"}).exit_code, 2);
}

TEST_F(CliGl, AGridSweepsASettingUnderTechniques) {
    const Arguments grid{"--technique",     "per-vertex/phong", "--technique",
                         "per-pixel/phong", "--sweep",          "objects[0].material.diffuse=[1,0,0],[0,0,1],[0,1,0]"};
    const ProcessResult result = capture("grid.png", grid);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(folder.names(), (Arguments{"grid.png", "grid.png.json"}));
    const std::string png = folder.read("grid.png"); // the width stands in bytes 16 to 19, the height in 20 to 23
    EXPECT_EQ(static_cast<unsigned char>(png.at(19)), 3 * 64);
    EXPECT_GE(static_cast<unsigned char>(png.at(23)), 2 * 48);
    EXPECT_EQ(run_sandbox({"capture", folder.file("grid.png.json"), "--out", folder.file("again.png")}).exit_code, 0);
    EXPECT_TRUE(same_bytes("grid.png", "again.png"));
    EXPECT_TRUE(same_bytes("grid.png.json", "again.png.json"));
    const auto refused = [&](const Arguments &more, const std::string &why) {
        const ProcessResult wrong = capture("wrong.png", more);
        EXPECT_EQ(wrong.exit_code, 2);
        EXPECT_NE(wrong.err.find(why), std::string::npos) << wrong.err;
    };
    refused({"--sweep", "blinn_exponent_scale"}, "--sweep: expected PATH=v1,v2");
    refused({"--sweep", "blinn_exponent_scale=1,-2"}, "--sweep: blinn_exponent_scale: expected a number > 0, got -2");
    refused({"--sweep", "glow=1"}, "glow");
    refused({"--sweep", "blinn_exponent_scale=1,2", "--frames", "2", "--orbit", "9"}, "one picture");
    refused({"--technique", "flat/phong", "--technique", "flat/lambert"}, "--sweep");
}

TEST_F(CliGl, TimePrintsJsonLines) {
    folder.write("lines", "2\n3\n");
    const ProcessResult result =
        run_sandbox({"time", "point-light", "--size", "16x16", "--frames", "-", "--out", folder.file("last.png")}, "",
                    "< '" + folder.file("lines") + "'");
    EXPECT_EQ(result.exit_code, 0) << result.err;
    std::istringstream lines(result.out);
    std::vector<nlohmann::json> json;
    for (std::string line; std::getline(lines, line);) {
        json.push_back(nlohmann::json::parse(line));
    }
    ASSERT_EQ(json.size(), 3U);
    EXPECT_TRUE(json[0].contains("case") && json[0].contains("renderer"));
    EXPECT_GT(json[0]["first_ns"].get<long long>(), 0);
    EXPECT_EQ(json[1]["ms"].size(), 2U);
    EXPECT_EQ(json[2]["ms"].size(), 3U);
    ASSERT_EQ(run_sandbox({"capture", "point-light", "--size", "16x16", "--out", folder.file("c.png")}).exit_code, 0);
    EXPECT_TRUE(same_bytes("last.png", "c.png")) << "what is timed is what is captured";
}

TEST_F(CliGl, TimeRefusesAWrongLine) {
    folder.write("lines", "1\nmany\n");
    const ProcessResult result =
        run_sandbox({"time", "point-light", "--size", "8x8", "--frames", "-"}, "", "< '" + folder.file("lines") + "'");
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_NE(result.err.find("many"), std::string::npos);
}

TEST_F(CliGl, CompareSaysZeroOfTheSame) {
    const ProcessResult same = run_sandbox({"compare", "point-light", "--left", "flat/phong", "--right", "flat/phong",
                                            "--size", "64x48", "--json", "--max-abs", "0"});
    EXPECT_EQ(same.exit_code, 0) << same.err;
    const auto json = nlohmann::json::parse(same.out);
    for (const char *key : {"rmse", "mean_abs", "max_abs", "p99_abs", "flip", "max_levels", "differing_share",
                            "silhouette_pixels", "edge_pixels", "nonfinite_pixels"}) {
        EXPECT_EQ(json.at(key), 0) << key;
    }
    EXPECT_TRUE(json.at("psnr").is_null());
    EXPECT_GT(json.at("compared_pixels"), 100);
    EXPECT_EQ(json.at("compared_share"), 1) << "between two drawn pictures nothing but silhouettes is masked";
    EXPECT_TRUE(json.at("reason").is_null());
    EXPECT_TRUE(json.at("same_picture"));
    EXPECT_NE(same.err.find("draw the same picture"), std::string::npos);
}

/// Pixels of background prove nothing: no number is perfect, and the check fails.
TEST_F(CliGl, CompareOfNothingSaysNothing) {
    for (const char *right : {"reference", "per-pixel/phong"}) {
        const ProcessResult result = run_sandbox({"compare", "point-light", "--left", "flat/lambert", "--right", right,
                                                  "--size", "1x1", "--set", "camera.target=[100,100,0]", "--json"});
        EXPECT_EQ(result.exit_code, 1) << result.err;
        EXPECT_NE(result.err.find("nothing is compared: neither picture shows an object"), std::string::npos);
        const auto json = nlohmann::json::parse(result.out);
        for (const char *key :
             {"rmse", "mean_abs", "max_abs", "p99_abs", "psnr", "max_levels", "differing_share", "compared_share",
              "silhouette_max_abs", "edge_max_abs", "jump_max_abs", "rounding_max_abs", "worst_pixel"}) {
            EXPECT_TRUE(json.at(key).is_null()) << key << " " << json.at(key);
        }
        EXPECT_EQ(json.at("compared_pixels"), 0);
        EXPECT_EQ(json.at("rounding_pixels"), 0);
        EXPECT_EQ(json.at("reason"), "neither picture shows an object");
    }
}

TEST_F(CliGl, WhatDoesNothingIsNamed) {
    // A ball that is only moved: its normals need no normal matrix; one lamp without ambient light.
    const ProcessResult result =
        run_sandbox({"compare", "point-light", "--left",
                     "per-pixel/phong:normals=model-matrix,gate=none,direction=unnegated-diffuse", "--right",
                     "reference", "--size", "32x24", "--json"});
    const auto json = nlohmann::json::parse(result.out);
    EXPECT_EQ(json.at("no_effect"), (nlohmann::json{"normals", "direction"}));
    EXPECT_FALSE(json.at("same_picture"));
    EXPECT_NE(result.err.find("normals=model-matrix has no effect"), std::string::npos);
    EXPECT_EQ(result.err.find("gate=none"), std::string::npos);
    const ProcessResult equal = run_sandbox({"compare", "point-light", "--left", "per-pixel/phong:normals=model-matrix",
                                             "--right", "per-pixel/phong", "--size", "32x24", "--json"});
    EXPECT_TRUE(nlohmann::json::parse(equal.out).at("same_picture"));
    EXPECT_NE(equal.err.find("draw the same picture"), std::string::npos);
    const ProcessResult glsl =
        run_sandbox({"glsl", "point-light", "--technique", "per-pixel/phong:normals=model-matrix"});
    EXPECT_NE(glsl.err.find("normals=model-matrix has no effect"), std::string::npos);
    EXPECT_EQ(glsl.out, run_sandbox({"glsl", "point-light", "--technique", "per-pixel/phong"}).out);
    const ProcessResult captured = capture("c.png");
    EXPECT_EQ(captured.err.find("no effect"), std::string::npos);
}

TEST_F(CliGl, CompareChecksABound) {
    const Arguments to_truth{"compare", "point-light", "--left",    "per-vertex/phong",
                             "--size",  "64x48",       "--max-abs", "1e-3"};
    const auto against = [&](const std::string &right) {
        Arguments all = to_truth;
        all.insert(all.end(), {"--right", right});
        return run_sandbox(all);
    };
    const ProcessResult far = against("reference");
    EXPECT_EQ(far.exit_code, 1);
    EXPECT_NE(far.err.find("max_abs"), std::string::npos);
    const ProcessResult near = against("reference:frequency=per-vertex");
    EXPECT_EQ(near.exit_code, 0) << near.err << near.out;
}

TEST_F(CliGl, AFileThatCannotBeWrittenLeavesNothingBehind) {
    std::filesystem::create_directory(folder.file("taken.png"));
    EXPECT_EQ(capture("taken.png").exit_code, 2);
    EXPECT_EQ(folder.names(), Arguments{"taken.png"});
}

TEST_F(CliGl, AnInterruptLeavesOnlyWholeFiles) {
    const ProcessResult result = run_sandbox({"capture", "point-light", "--out", folder.file("t_%d.pfm"), "--size",
                                              "40x30", "--frames", "100000", "--orbit", "360"},
                                             "timeout --preserve-status -s INT 1");
    EXPECT_EQ(result.exit_code, 130) << result.err;
    for (const std::string &name : folder.names()) {
        EXPECT_TRUE(name.ends_with(".pfm") || name.ends_with(".pfm.json")) << name;
        if (name.ends_with(".pfm")) {
            EXPECT_EQ(folder.read(name).size(), std::string("PF\n40 30\n-1.0\n").size() + 40 * 30 * 12) << name;
        }
    }
}

} // namespace
} // namespace sandbox

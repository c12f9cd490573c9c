#include "commands/process.h"
#include "shading/technique.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>

/// The built program's command line, as far as it needs no OpenGL.
namespace sandbox {
namespace {

/// Expects exit code 2, nothing on standard output, and `said` in the message.
void expect_refused(const Arguments &arguments, const std::string &said) {
    const ProcessResult result = run_sandbox(arguments);
    const std::string line = testing::PrintToString(arguments);
    EXPECT_EQ(result.exit_code, 2) << line;
    EXPECT_EQ(result.out, "") << line;
    EXPECT_EQ(result.err.rfind("shading-sandbox: ", 0), 0U) << line << "\n" << result.err;
    EXPECT_NE(result.err.find(said), std::string::npos) << line << "\n" << result.err;
}

TEST(Cli, VersionAndHelp) {
    EXPECT_EQ(run_sandbox({"--version"}).out, "shading-sandbox " SANDBOX_VERSION "\n");
    const ProcessResult help = run_sandbox({"--help"});
    EXPECT_EQ(help.exit_code, 0);
    for (const char *word :
         {"capture", "reference", "compare", "time", "glsl", "list", "--set", "--shaders", "--assets", "--backend",
          "interpolated-vectors", "half_vector", "distance-interpolated", "Exit code"}) {
        EXPECT_NE(help.out.find(word), std::string::npos) << word;
    }
    EXPECT_EQ(run_sandbox({"capture", "--help"}).exit_code, 0);
}

TEST(Cli, BadUsage) {
    expect_refused({"capture"}, "SCENE is required");
    expect_refused({"capture", "point-light"}, "--out is required");
    expect_refused({"capture", "point-light", "--out", "a.png", "--bogus"}, "--bogus");
    expect_refused({"point-light", "capture", "vase", "--out", "a.png"}, "'point-light'");
    expect_refused({"glsl", "point-light", "--technique", "flat/phong", "--stage", "geometry"}, "geometry");
    expect_refused({"list", "--shaders", "/nowhere"}, "--shaders");
    expect_refused({"no-such-scene"}, "no-such-scene");
}

TEST(Cli, SettingsAreRefusedWhereNoSceneIsOpened) {
    expect_refused({"list", "--set", "eye=[0,0,1]"}, "--set eye=[0,0,1]: list opens no scene");
    expect_refused({"stability", "--out", "a", "--set", "eye=[0,0,1]"}, "--set eye=[0,0,1]: a case brings");
    expect_refused({"lesson", "all", "--check", "--set", "eye=[0,0,1]"}, "--set eye=[0,0,1]: a lesson brings");
}

TEST(Cli, AMistypedCommandGetsASuggestion) {
    expect_refused({"cature"}, "'cature' is neither a command nor a built-in scene; did you mean \"capture\"?");
    expect_refused({"cature", "point-light", "--out", "a.png"}, "did you mean \"capture\"?");
    expect_refused({"stablity", "--out", "a"}, "did you mean \"stability\"?");
    expect_refused({"poin-light"}, "did you mean \"point-light\"?");
    expect_refused({"poin-light.json"}, "poin-light.json: no such file");
}

TEST(Cli, SizesAreRefusedBeforeAnythingIsDrawn) {
    for (const char *size : {"", "12", "12x", "x12", "1x2x3", "0x5", "5x0", "-5x5", "16385x1", "1x16385", "16384x16384",
                             "8192x8193", "99999999999x1", "1 x 1", "640X480", "1e3x10", "+5x5"}) {
        expect_refused({"capture", "point-light", "--out", "a.png", "--size", size}, "--size");
    }
}

TEST(Cli, OutputNamesAreRefusedBeforeAnythingIsDrawn) {
    expect_refused({"capture", "point-light", "--out", "a.jpg"}, ".png or .pfm");
    expect_refused({"capture", "point-light", "--out", ""}, "--out");
    expect_refused({"capture", "point-light", "--out", "/nowhere/a.png"}, "/nowhere");
    expect_refused({"time", "point-light", "--out", "a.pfm"}, ".png");
    expect_refused({"capture", "point-light", "--out", "a_%04d.png"}, "--frames");
    expect_refused({"capture", "point-light", "--out", "a.png", "--frames", "2", "--orbit", "90"}, "%04d");
    expect_refused({"capture", "point-light", "--out", "a_%s.png", "--frames", "2", "--orbit", "90"}, "%04d");
}

TEST(Cli, CaptureFlagsThatContradictEachOther) {
    const auto refused = [](Arguments flags, const std::string &said) {
        flags.insert(flags.begin(), {"capture", "point-light"});
        expect_refused(flags, said);
    };
    refused({"--out", "a.png", "--left", "flat/phong"}, "--right");
    refused({"--out", "a.png", "--layout", "wipe"}, "--left");
    refused({"--out", "a.png", "--technique", "flat/phong", "--left", "flat/phong"}, "--technique");
    refused({"--out", "a.png", "--gain", "2"}, "--gain");
    refused({"--out", "a.png", "--samples", "0"}, "--samples: expected a whole number from 1 to 256");
    refused({"--out", "a.png", "--samples", "4", "--pixel", "0.5,0.5", "--loupe"}, "--samples");
    refused({"--out", "a.pfm", "--samples", "4"}, "--samples");
    refused({"--out", "a.png", "--exposure", "nan"}, "--exposure");
    refused({"--out", "a.png", "--exposure", "-1"}, "--exposure: expected a number >= 0, got -1");
    refused({"--out", "a.png", "--display", "gamma"}, "--display");
    refused({"--out", "a.pfm", "--exposure", "2"}, "--exposure");
    refused({"--out", "a.pfm", "--labels"}, "--labels");
    refused({"--out", "a%d.png", "--frames", "0", "--orbit", "1"}, "--frames");
    refused({"--out", "a%d.png", "--frames", "2"}, "--orbit");
    refused({"--out", "a%d.png", "--frames", "2", "--orbit", "inf"}, "--orbit");
    refused({"--out", "a%d.png", "--frames", "2", "--orbit", "2e9"}, "--orbit: expected a number from -1e9 to 1e9");
    refused({"--out", "a.png", "--view", "nowhere"}, "nowhere");
    refused({"--out", "a.png", "--set", "lights[0].diffuse=-1"}, "lights[0].diffuse");
    refused({"--out", "a.png", "--technique", "per-vertex/phong:renormalize=off"}, "renormalize");
    refused({"--out", "a.png", "--left", "flat/phong", "--right", "flat/phong", "--size", "1x1"}, "width");
}

TEST(Cli, TheOtherCommandsCheckTheirWordsFirst) {
    expect_refused({"compare", "vase", "--left", "reference", "--right", "reference"}, "--left");
    expect_refused({"compare", "vase", "--left", "flat/phong", "--right", "reference:foo=bar"}, "--right");
    expect_refused({"compare", "vase", "--left", "flat/phong", "--right", "referenc"}, "--right");
    expect_refused({"compare", "vase", "--left", "flat/phong", "--right", "reference", "--max-abs", "-1"}, "--max-abs");
    expect_refused({"view", "vase", "--left", "flat/fong"}, "--left");
    expect_refused({"view", "vase", "--set", "compare.left=flat/fong"}, "vase: compare.left: ");
    expect_refused({"reference", "vase", "--out", "a.png", "--set", "compare.layout=beside"}, "vase: compare.layout: ");
    expect_refused({"view", "vase", "--right", "per-pixel"}, "--right");
    for (const char *frames : {"0", "-1", "x", "3x", "", "1000001"}) {
        expect_refused({"time", "vase", "--frames", frames}, "--frames");
    }
    expect_refused({"reference", "vase", "--out", "a.png", "--surface", "analytic"}, "analytic");
}

TEST(Cli, ASidecarIsCheckedLikeFlags) {
    const TemporaryFolder folder;
    for (const std::string wrong :
         {R"("size": [0, 5])", R"("size": [99999, 99999])", R"("size": [1e300, 5])", R"("size": [64.5, 5])",
          R"("exposure": -1)", R"("exposure": 1e9)", R"("gain": 0)"}) {
        folder.write("a.png.json", R"({"scene": {"objects": []}, "techniques": ["flat/phong"], )" + wrong + "}");
        expect_refused({"capture", folder.file("a.png.json"), "--out", folder.file("b.png")},
                       "a.png.json: " + wrong.substr(1, wrong.find(':') - 2));
    }
}

TEST(Cli, ListAsJson) {
    const auto list = nlohmann::json::parse(run_sandbox({"list", "--json"}).out);
    EXPECT_FALSE(list["scenes"].empty());
    for (const auto &scene : list["scenes"]) {
        EXPECT_FALSE(scene["name"].get<std::string>().empty());
        EXPECT_FALSE(scene["description"].get<std::string>().empty());
    }
    EXPECT_EQ(list["techniques"]["frequencies"].size(), 6U);
    EXPECT_EQ(list["techniques"]["models"].size(), 4U) << "three with an equation, and own shading";
    EXPECT_EQ(list["techniques"]["keys"].size(), std::size(technique_settings));
    EXPECT_TRUE(list["lessons"].is_array());
    EXPECT_TRUE(list["stability"].is_array());
}

TEST(Cli, GlslPrintsOneProgram) {
    const TemporaryFolder folder;
    folder.write("two.json", R"({"lights": [{"type": "point", "position": [1, 2, 3]}], "objects": [
        {"name": "ball", "mesh": {"shape": "sphere"}},
        {"name": "matt", "mesh": {"shape": "sphere"}, "material": {"specular": [0, 0, 0]}},
        {"mesh": {"shape": "sphere"}}]})");
    const Arguments glsl{"glsl", folder.file("two.json"), "--technique", "per-pixel/phong"};
    const auto with = [&](Arguments more) {
        more.insert(more.begin(), glsl.begin(), glsl.end());
        return run_sandbox(more);
    };
    const ProcessResult both = with({});
    EXPECT_EQ(both.exit_code, 0);
    EXPECT_NE(both.err.find("matt"), std::string::npos) << "the note names the other program's object";
    EXPECT_EQ(both.err.find("objects[2]"), std::string::npos) << "the third object shares the first one's program";
    const std::string vertex = with({"--stage", "vertex"}).out;
    const std::string fragment = with({"--stage", "fragment"}).out;
    EXPECT_EQ(both.out, "// ---- vertex stage ----\n" + vertex + "\n// ---- fragment stage ----\n" + fragment);
    EXPECT_EQ(vertex.rfind("#version 330 core", 0), 0U);
    EXPECT_NE(fragment.find("pow("), std::string::npos);
    EXPECT_EQ(with({"--object", "matt"}).out.find("pow("), std::string::npos);
    EXPECT_EQ(with({"--object", "objects[2]"}).out, both.out);
    EXPECT_EQ(with({"--object", "nobody"}).exit_code, 2);
}

TEST(Cli, ReferenceWritesAPfm) {
    const TemporaryFolder folder;
    const ProcessResult result =
        run_sandbox({"reference", "point-light", "--out", folder.file("a.pfm"), "--size", "7x5"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out + result.err, "");
    EXPECT_EQ(folder.names(), Arguments{"a.pfm"});
    EXPECT_EQ(folder.read("a.pfm").rfind("PF\n7 5\n-1", 0), 0U);
}

TEST(Cli, WithoutADisplayServerTheWindowSaysWhatToDo) {
    const ProcessResult result = run_sandbox({}, "env -u DISPLAY -u WAYLAND_DISPLAY");
    EXPECT_EQ(result.exit_code, 3);
    EXPECT_NE(result.err.find("capture"), std::string::npos) << result.err;
}

TEST(Cli, OutputThatCannotBeWrittenIsAnError) {
    // The later redirection wins.
    EXPECT_EQ(run_sandbox({"list"}, "", "> /dev/full").exit_code, 2);
    EXPECT_EQ(run_sandbox({"--help"}, "", "> /dev/full").exit_code, 2);
    EXPECT_EQ(run_sandbox({"list"}, "", ">&-").exit_code, 2);
}

TEST(Cli, HostileFilesAreRefusedInOneSentence) {
    const TemporaryFolder folder;
    const std::string deep = std::string(100000, '[') + std::string(100000, ']');
    folder.write("deep.json", R"({"scene": {}, "techniques": )" + deep + "}");
    expect_refused({"capture", folder.file("deep.json"), "--out", "a.png"},
                   "deep.json: nested deeper than 64 levels\n");
    folder.write("report.json", R"({"format": "shading-sandbox report 1", "runs": [{"scene": )" + deep + "}]}");
    expect_refused({"report", "--merge", folder.file("report.json"), "--out", folder.file("out")},
                   "report.json: nested deeper than 64 levels\n");
    folder.write("escape.json", R"({"objects": [{"mesh": {"shape": "box"}, "\u001b[2J\u001b]0;title\u0007key": 1}]})");
    expect_refused({"capture", folder.file("escape.json"), "--out", "a.png"},
                   R"(objects[0].\x1B[2J\x1B]0;title\x07key: unknown key of this object)");
}

TEST(Cli, OnlyRegularFilesAreRead) {
    const TemporaryFolder folder;
    ASSERT_EQ(::mkfifo(folder.file("pipe.png").c_str(), 0600), 0);
    ASSERT_EQ(::mkfifo(folder.file("pipe.json").c_str(), 0600), 0);
    expect_refused({"glsl", folder.file("pipe.json"), "--technique", "flat/phong"},
                   "pipe.json: expected a regular file, got a pipe");
    folder.write("a.json", R"({"objects": [{"mesh": {"shape": "box"}, "material": {"texture": "pipe.png"}}]})");
    expect_refused({"reference", folder.file("a.json"), "--out", folder.file("a.pfm")},
                   "objects[0].material.texture: " + folder.file("pipe.png") + ": expected a regular file, got a pipe");
    expect_refused({"glsl", "/dev/zero", "--technique", "flat/phong"}, "/dev/zero: expected a .json or .obj file");
}

TEST(Cli, PathsThatAreNoUtf8AreRefusedFirst) {
    const TemporaryFolder folder;
    expect_refused({"report", "vase", "--out", folder.file("caf\xE9")}, R"(caf\xE9': expected UTF-8 text; rename)");
    EXPECT_EQ(folder.names().size(), 0U);
    std::filesystem::create_directory(folder.file("caf\xE9"));
    folder.write("caf\xE9/a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const ProcessResult within =
        run_sandbox({"glsl", "./a.obj", "--technique", "flat/phong"}, "cd '" + folder.file("caf\xE9") + "' &&");
    EXPECT_EQ(within.exit_code, 2);
    EXPECT_NE(within.err.find(R"(caf\xE9/a.obj: expected a path of UTF-8 text)"), std::string::npos) << within.err;
}

TEST(Cli, AnInterruptLeavesNoHalfWrittenFile) {
    const TemporaryFolder folder;
    // Long enough to be interrupted on any machine; `timeout` sends the signal and passes the exit code on.
    for (const char *signal : {"INT", "TERM"}) {
        const ProcessResult result =
            run_sandbox({"reference", "three-point-lights", "--out", folder.file("a.png"), "--size", "8192x8192"},
                        std::string("timeout --preserve-status -s ") + signal + " 1");
        EXPECT_EQ(result.exit_code, 130) << signal << result.err;
        EXPECT_EQ(folder.names(), Arguments{}) << signal;
    }
}

} // namespace
} // namespace sandbox

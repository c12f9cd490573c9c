#include "commands/process.h"

#include <gtest/gtest.h>

/// `own`, and how commands take its files, as far as no picture is drawn.
namespace sandbox {
namespace {

const std::string plain = "vec3 lighting(vec3 P, vec3 N, vec3 eye)\n{\n    return vec3(0.5);\n}\n";

TEST(OwnCommand, WritesAStarterAndAnAnswer) {
    const ProcessResult starter = run_sandbox({"own", "--starter"});
    EXPECT_EQ(starter.exit_code, 0) << starter.err;
    for (const char *word :
         {"vec3 lighting(vec3 P, vec3 N, vec3 eye)\n{\n    return vec3(0.0);\n}\n", "float cos_cutoff;",
          "float cutoff_degrees;", "vec3 base();", "mat3 normal_matrix;", "vec3 normal(vec3 n)"}) {
        EXPECT_NE(starter.out.find(word), std::string::npos) << word << starter.out;
    }
    const ProcessResult answer =
        run_sandbox({"own", "directional-light", "--answer", "--technique", "per-vertex/phong"});
    EXPECT_EQ(answer.exit_code, 0) << answer.err;
    EXPECT_NE(answer.out.find("compare directional-light --left per-vertex/own"), std::string::npos);
    EXPECT_NE(answer.out.find("reflect(-L, N)"), std::string::npos);
    for (const char *word : {"SPOT", "quadratic", "base()", "blinn", "#"}) {
        EXPECT_EQ(answer.out.find(word), std::string::npos) << word << " is not needed there:\n" << answer.out;
    }
    const TemporaryFolder folder;
    EXPECT_EQ(run_sandbox({"own", "--starter", "--out", folder.file("a.glsl")}).exit_code, 0);
    EXPECT_EQ(folder.read("a.glsl"), starter.out);
}

TEST(OwnCommand, RefusesWhatItCannotWrite) {
    const std::pair<Arguments, std::string> refused[] = {
        {{"own"}, "expected either --starter or --answer"},
        {{"own", "--starter", "--answer"}, "expected either --starter or --answer"},
        {{"own", "--answer", "--technique", "hybrid/phong"}, "--technique: expected flat, per-vertex or per-pixel"},
        {{"own", "--answer", "--technique", "per-pixel/phong:gate=none"}, "with a model and no keys"},
        {{"own", "--answer", "--technique", "per-pixel/own"}, "needs a text"},
        {{"own", "--answer", "--out", "a.txt"}, "ends in .glsl"},
        {{"own", "--answer", "--set", "ambient=[1,1,1]"}, "none is given"}};
    for (const auto &[arguments, message] : refused) {
        const ProcessResult result = run_sandbox(arguments);
        EXPECT_EQ(result.exit_code, 2) << message;
        EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
    }
}

TEST(OwnFiles, AreReadOrRefused) {
    const TemporaryFolder folder;
    folder.write("plain.glsl", plain);
    folder.write("bad.glsl", "\n#extension all : enable\n");
    folder.write("large.glsl", std::string(100000, '\n'));
    const auto glsl = [&](const std::string &technique, const Arguments &more) {
        Arguments arguments{"glsl", "point-light", "--technique", technique};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run_sandbox(arguments);
    };
    const ProcessResult drawn = glsl("per-pixel/own", {"--own", folder.file("plain.glsl")});
    EXPECT_EQ(drawn.exit_code, 0) << drawn.err;
    EXPECT_NE(drawn.out.find(plain), std::string::npos) << drawn.out;
    EXPECT_EQ(drawn.out.find("a_normal"), std::string::npos) << "the text reads no normal";
    const std::tuple<std::string, Arguments, std::string> refused[] = {
        {"per-pixel/own", {}, "--technique: technique 'per-pixel/own' is refused: model=own needs a text"},
        {"per-pixel/own", {"--own", folder.file("none.glsl")}, "none.glsl': expected a file of GLSL text"},
        {"per-pixel/own", {"--own", "/dev/zero"}, "expected a file of GLSL text"},
        {"per-pixel/own", {"--own", folder.file("bad.glsl")}, "bad.glsl:2: #extension is not accepted"},
        {"per-pixel/own", {"--own", folder.file("large.glsl")}, "expected at most 65536 bytes, got 100000"},
        {"hybrid/own", {"--own", folder.file("plain.glsl")}, "is for flat, per-vertex and per-pixel"},
        {"per-pixel/own:program=full", {"--own", folder.file("plain.glsl")}, "has no meaning beside the model own"},
        {"per-pixel/phong", {"--own", folder.file("plain.glsl")}, "--own: no technique here has the model own"}};
    for (const auto &[technique, more, message] : refused) {
        const ProcessResult result = glsl(technique, more);
        EXPECT_EQ(result.exit_code, 2) << message;
        EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
    }
}

/// Commands that take no file of own shading refuse its model before they begin.
TEST(OwnFiles, AreAskedForEverywhere) {
    const TemporaryFolder folder;
    for (const Arguments &arguments :
         {Arguments{"reference", "point-light", "--out", folder.file("a.png"), "--technique", "per-pixel/own"},
          Arguments{"view", "point-light", "--left", "per-pixel/own"}}) {
        const ProcessResult result = run_sandbox(arguments);
        EXPECT_EQ(result.exit_code, 2) << arguments[0];
        EXPECT_NE(result.err.find("needs a text"), std::string::npos) << result.err;
    }
}

} // namespace
} // namespace sandbox

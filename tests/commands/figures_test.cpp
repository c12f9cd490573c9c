#include "commands/process.h"

#include <gtest/gtest.h>

/// What `figures` refuses before it draws.
namespace sandbox {
namespace {

TEST(FiguresCommand, RefusesBadInput) {
    const TemporaryFolder folder;
    folder.write("file", "");
    folder.write("empty.json", R"({"objects": []})");
    folder.write("bad.json", R"({"objects": [{"mesh": {"shape": "sphere", "rings": -1}}]})");
    folder.write("compare.json", R"({"compare": {"left": "round/phong"}, "objects": [{"mesh": {"shape": "box"}}]})");
    const auto refused = [&](Arguments arguments, const std::string &said) {
        arguments.insert(arguments.begin(), "figures");
        const ProcessResult result = run_sandbox(arguments);
        EXPECT_EQ(result.exit_code, 2) << result.err;
        EXPECT_NE(result.err.find(said), std::string::npos) << result.err;
    };
    const std::string out = folder.file("out");
    refused({"studoi", "--out", out}, "did you mean \"studio\"?");
    refused({"studio"}, "--out");
    refused({"studio", "--out", folder.file("file")}, "--out: cannot make the folder");
    refused({folder.file("empty.json"), "--out", out}, "objects: expected at least one");
    refused({folder.file("bad.json"), "--out", out}, "objects[0].mesh.rings");
    refused({folder.file("compare.json"), "--out", out}, "compare.left");
    refused({"studio", "--out", out, "--left", "round/phong"}, "--left: ");
    refused({"studio", "--out", out, "--set", "lights[9].diffuse=1"}, "lights[9]");
    refused({"studio", "--out", out, "--view", "none"}, "none");
    refused({"studio", "--out", out, "--size", "16x16"}, "--size: expected at least 32x32");
    refused({"studio", "--out", out, "--size", "7000x32"}, "--size: ");
    refused({"studio", "--out", out, "--lang", "fr"}, "--lang: expected en or zh");
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"bad.json", "compare.json", "empty.json", "file"}))
        << "nothing is left behind";
}

} // namespace
} // namespace sandbox

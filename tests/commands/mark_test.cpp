#include "commands/process.h"

#include <gtest/gtest.h>

/// What `mark` does and refuses before it draws.
namespace sandbox {
namespace {

const std::string black = "vec3 lighting(vec3 P, vec3 N, vec3 eye) { return vec3(0.0); }";

TEST(MarkCommand, BadUsageIsRefusedByName) {
    const TemporaryFolder folder;
    folder.write("a.glsl", black);
    const auto refused = [&](const Arguments &arguments, const std::string &said) {
        Arguments all{"mark"};
        all.insert(all.end(), arguments.begin(), arguments.end());
        const ProcessResult result = run_sandbox(all);
        EXPECT_EQ(result.exit_code, 2) << result.err;
        EXPECT_EQ(result.out, "");
        EXPECT_NE(result.err.find(said), std::string::npos) << result.err;
    };
    refused({"fong", folder.file("a.glsl")}, "fong: no built-in exercise of that name; did you mean \"phong\"?");
    refused({"phong"}, "mark: expected an ANSWER, or --student");
    refused({"phong", folder.file("none.glsl")}, "there is no such file or folder");
    refused({"phong", folder.file("a.glsl"), "--hints", "4"}, "--hints: expected 0 to 3, got 4");
    refused({"phong", folder.file("a.glsl"), "--lang", "fr"}, "--lang: ");
    refused({"phong", folder.file("a.glsl"), "--set", "lights[0].diffuse=1"}, "an exercise brings its own scenes");
    std::filesystem::create_directory(folder.path() / "empty");
    refused({"phong", folder.file("empty")}, "no .glsl, .png or .pfm file is in it");
    folder.write("bad.json", R"({"title": "T"})");
    refused({folder.file("bad.json"), folder.file("a.glsl")}, "task: missing");
}

TEST(MarkCommand, StudentsGetACopyAndAFileToBeginWith) {
    const TemporaryFolder folder;
    const ProcessResult result = run_sandbox({"mark", "lambert", "--student", folder.file("out"), "--lang", "zh"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(folder.read("out/lambert.json").find("withheld"), std::string::npos);
    EXPECT_NE(folder.read("out/lambert.json").find("漫反射"), std::string::npos);
    EXPECT_NE(folder.read("out/lambert.glsl").find("vec3 lighting(vec3 P, vec3 N, vec3 eye)"), std::string::npos);
}

TEST(MarkCommand, ExercisesAreListed) {
    const ProcessResult result = run_sandbox({"list"});
    EXPECT_NE(result.out.find("\nExercises\n"), std::string::npos);
    EXPECT_NE(result.out.find("stiff-highlight"), std::string::npos);
}

} // namespace
} // namespace sandbox

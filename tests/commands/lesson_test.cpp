#include "commands/process.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

/// What `lesson` refuses before it draws, and how `list` names lessons.
namespace sandbox {
namespace {

TEST(LessonCommand, RefusesBadLessons) {
    const TemporaryFolder folder;
    folder.write("broken.json", R"({"titel": "x"})");
    const auto refused = [&](const std::string &lesson, const std::string &said) {
        const ProcessResult result = run_sandbox({"lesson", lesson, "--out", folder.file("out")});
        EXPECT_EQ(result.exit_code, 2) << result.err;
        EXPECT_NE(result.err.find(said), std::string::npos) << result.err;
    };
    refused("vertex-or-pixle", "no built-in lesson of that name; did you mean \"vertex-or-pixel\"?");
    refused(folder.file("none.json"), "none.json");
    refused(folder.file("broken.json"), "titel: unknown key of this lesson; did you mean \"title\"?");
    EXPECT_NE(run_sandbox({"lesson", "vertex-or-pixel", "--set", "ambient=[1,1,1]"}).err.find("--set ambient"),
              std::string::npos);
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"broken.json"})) << "nothing is left behind";
}

TEST(LessonCommand, ListNamesLessonsInTheirOrder) {
    const ProcessResult result = run_sandbox({"list", "--json"});
    const auto lessons = nlohmann::json::parse(result.out)["lessons"];
    ASSERT_FALSE(lessons.empty());
    EXPECT_EQ(lessons[0]["name"], "vertex-or-pixel");
    EXPECT_EQ(lessons[0]["title"], "Per vertex or per pixel") << "not its key";
    EXPECT_NE(run_sandbox({"list"}).out.find("Per vertex or per pixel"), std::string::npos);
    const auto bugs = nlohmann::json::parse(result.out)["bugs"];
    ASSERT_FALSE(bugs.empty());
    EXPECT_NE(bugs[0]["source"], "");
}

} // namespace
} // namespace sandbox

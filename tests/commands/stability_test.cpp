#include "commands/process.h"

#include <gtest/gtest.h>

/// What `stability` refuses before it draws.
namespace sandbox {
namespace {

TEST(StabilityCommand, CasesAreCheckedBeforeAnythingIsDrawn) {
    const TemporaryFolder folder;
    folder.write("broken.json", "{");
    folder.write("short.json", R"({"group": "mine"})");
    const auto refused = [&](const std::vector<std::string> &flags, const std::string &said) {
        std::vector<std::string> arguments{"stability", "--out", folder.file("out")};
        arguments.insert(arguments.end(), flags.begin(), flags.end());
        const ProcessResult result = run_sandbox(arguments);
        EXPECT_EQ(result.exit_code, 2) << result.err;
        EXPECT_EQ(result.out, "");
        EXPECT_NE(result.err.find(said), std::string::npos) << result.err;
    };
    refused({"--case", "spot-cutof-0"}, "--case: there is no case 'spot-cutof-0'; did you mean 'spot-cutoff-0'?");
    refused({"--case", folder.file("none.json")}, "none.json");
    refused({"--case", folder.file("broken.json")}, "broken.json:1:2: syntax error");
    refused({"--case", folder.file("short.json")}, "short.json: symptom: missing");
    refused({"--assets", folder.file("")}, "--assets: expected cases");
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"broken.json", "short.json"})) << "nothing is left behind";
}

} // namespace
} // namespace sandbox

#include "commands/process.h"

#include <gtest/gtest.h>

namespace sandbox {
namespace {

TEST(Report, WordsAreCheckedBeforeAnythingIsMeasured) {
    const TemporaryFolder folder;
    const std::string out = folder.file("out");
    folder.write("other.json", "{}");
    const auto refused = [](const Arguments &arguments, const std::string &said) {
        const ProcessResult result = run_sandbox(arguments);
        EXPECT_EQ(result.exit_code, 2) << result.err;
        EXPECT_EQ(result.out, "");
        EXPECT_NE(result.err.find(said), std::string::npos) << result.err;
    };
    refused({"report", "vase"}, "--out is required");
    refused({"report", "--out", out}, "SCENE");
    refused({"report", "no-such-scene", "--out", out}, "no-such-scene");
    refused({"report", "vase", "--out", out, "--size", "0x5"}, "--size");
    refused({"report", "vase", "--out", out, "--repeats", "0"}, "--repeats");
    refused({"report", "vase", "--out", "/proc/none"}, "--out");
    refused({"report", "--merge", folder.file("other.json"), "--out", out}, "other.json");
    refused({"report", "--merge", folder.file("none.json"), "--out", out}, "none.json");
    EXPECT_EQ(folder.names(), Arguments{"other.json"}) << "nothing is left behind";
}

} // namespace
} // namespace sandbox

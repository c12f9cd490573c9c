#include "commands/gl_command_test.h"

#include <nlohmann/json.hpp>

/// The report of the built program.
namespace sandbox {
namespace {

class ReportGl : public GlCommandTest {
  protected:
    [[nodiscard]] ProcessResult report(const std::string &name, Arguments more = {}) const {
        more.insert(more.begin(), {"report", "box-5-specular", "--out", folder.file(name), "--quick", "--size", "48x36",
                                   "--repeats", "1"});
        return run_sandbox(more);
    }
    [[nodiscard]] nlohmann::json json_of(const std::string &name) const {
        return nlohmann::json::parse(folder.read(name + "/report.json"));
    }
};

TEST_F(ReportGl, WritesThreeFilesWithTheSameErrorsEveryTime) {
    const ProcessResult result = report("a");
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out, "");
    ASSERT_EQ(report("b").exit_code, 0);
    const auto a = json_of("a")["runs"][0];
    const auto b = json_of("b")["runs"][0];
    EXPECT_TRUE(a["finished"]);
    EXPECT_EQ(a["truth"], "analytic surface");
    ASSERT_EQ(a["rows"].size(), b["rows"].size());
    for (std::size_t i = 0; i < a["rows"].size(); ++i) {
        EXPECT_EQ(a["rows"][i]["errors"], b["rows"][i]["errors"]);
        EXPECT_EQ(a["rows"][i]["errors"]["nonfinite_pixels"], 0);
    }
    EXPECT_NE(folder.read("a/report.html").find("</html>"), std::string::npos);
    EXPECT_NE(folder.read("a/report.csv").find("technique"), std::string::npos);
}

TEST_F(ReportGl, MergesRuns) {
    ASSERT_EQ(report("a").exit_code, 0);
    const ProcessResult merged = run_sandbox({"report", "--merge", folder.file("a/report.json"),
                                              folder.file("a/report.json"), "--out", folder.file("both")});
    ASSERT_EQ(merged.exit_code, 0) << merged.err;
    EXPECT_EQ(json_of("both")["runs"].size(), 2U);
    EXPECT_NE(folder.read("both/report.html").find("Runs side by side"), std::string::npos);
}

TEST_F(ReportGl, ARowThatNeedsTooManyVaryingsIsListedWithItsReason) {
    std::string lights;
    for (int i = 0; i < 9; ++i) {
        lights += std::string(i > 0 ? "," : "") + R"({"type": "point", "position": [1, 2, 3]})";
    }
    folder.write("one.obj", "v -1 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"); // a mesh from a file has no ladder and no surface
    folder.write("nine.json", R"({"lights": [)" + lights + R"(], "objects": [{"mesh": {"obj": "one.obj"}}]})");
    const ProcessResult result = run_sandbox({"report", folder.file("nine.json"), "--out", folder.file("nine"),
                                              "--quick", "--size", "32x24", "--repeats", "1"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(json_of("nine")["runs"][0]["truth"], "finest mesh");
    EXPECT_EQ(json_of("nine")["runs"][0]["meshes"].size(), 1U);
    const auto rows = json_of("nine")["runs"][0]["rows"];
    int refused = 0;
    for (const auto &row : rows) {
        refused += row.contains("refused") ? 1 : 0;
    }
    EXPECT_GT(refused, 0);
    EXPECT_NE(folder.read("nine/report.html").find("refused: "), std::string::npos);
}

TEST_F(ReportGl, AnInterruptKeepsWhatWasMeasured) {
    // With a tenth done there is something to keep, and so many repeats are never done.
    const ProcessResult result =
        run_sandbox({"report", "point-light", "--out", folder.file("a"), "--size", "320x240", "--repeats", "10000"},
                    "bash " SOURCE_DIR "/tests/commands/interrupted.sh 'report: [1-9][0-9]'");
    EXPECT_EQ(result.exit_code, 130) << result.err;
    EXPECT_FALSE(json_of("a")["runs"][0]["finished"]);
    EXPECT_NE(folder.read("a/report.html").find("Incomplete"), std::string::npos);
}

} // namespace
} // namespace sandbox

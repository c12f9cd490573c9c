#include "commands/gl_command_test.h"

#include <nlohmann/json.hpp>

/// `lesson` of the built program.
namespace sandbox {
namespace {

class LessonGl : public GlCommandTest {
  protected:
    void SetUp() override {
        GlCommandTest::SetUp();
        const std::string begin = R"({"title": "Gates", "steps": [{"title": "Highlights", "text": "They differ.",
            "scene": "point-light", "left": "per-vertex/phong", "right": "per-pixel/phong",
            "look": {"at": [0.5, 0.5]}, "question": {"asks": "Why?", "answer": "Vertices."},
            "claims": [{"says": "They differ", "metric": "max_abs", "against": "right", "size": "64x48", )";
        folder.write("true.json", begin + R"("above": 1e-6}]}]})");
        folder.write("false.json", begin + R"("below": 1e-6}]}]})");
    }
};

TEST_F(LessonGl, ChecksALessonFromAFile) {
    const ProcessResult good = run_sandbox({"lesson", folder.file("true.json"), "--check"});
    EXPECT_EQ(good.exit_code, 0) << good.err;
    EXPECT_NE(good.out.find("ok     They differ: "), std::string::npos) << good.out;
    const ProcessResult bad = run_sandbox({"lesson", folder.file("false.json"), "--check", "--json"});
    EXPECT_EQ(bad.exit_code, 1);
    EXPECT_NE(bad.err.find("false: a claim does not hold: They differ"), std::string::npos) << bad.err;
    EXPECT_EQ(nlohmann::json::parse(bad.out)["lessons"][0]["passed"], false);
}

TEST_F(LessonGl, WritesAPageAndASlideAStep) {
    const ProcessResult result = run_sandbox({"lesson", folder.file("true.json"), "--out", folder.file("out")});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(folder.read("out/true-01.png").substr(1, 3), "PNG");
    const std::string page = folder.read("out/true.html");
    for (const char *part : {"<h1>Gates</h1>", "<details><summary>Why?</summary>", "data:image/png;base64,", "holds"}) {
        EXPECT_NE(page.find(part), std::string::npos) << part;
    }
    EXPECT_EQ(page.find("src=\"http"), std::string::npos) << "self-contained";
}

} // namespace
} // namespace sandbox

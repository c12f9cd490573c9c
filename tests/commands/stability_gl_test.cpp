#include "commands/gl_command_test.h"

#include <nlohmann/json.hpp>

/// `stability` of the built program.
namespace sandbox {
namespace {

class StabilityGl : public GlCommandTest {
  protected:
    [[nodiscard]] ProcessResult stability(const std::string &chosen, const std::string &language = "en") const {
        return run_sandbox({"stability", "--out", folder.file("out"), "--json", "--case", chosen, "--lang", language});
    }
};

TEST_F(StabilityGl, RunsABuiltInCaseByItsName) {
    const ProcessResult result = stability("spot-cutoff-0");
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(nlohmann::json::parse(result.out)["cases"][0]["name"], "spot-cutoff-0");
    EXPECT_EQ(folder.read("out/stability.json"), result.out);
    EXPECT_NE(folder.read("out/stability.csv").find("spot-cutoff-0,spot,robust"), std::string::npos);
    EXPECT_NE(folder.read("out/stability.html").find("within its bound"), std::string::npos);
}

/// What programs read is the same in every language.
TEST_F(StabilityGl, ItsPageIsInALanguage) {
    const ProcessResult chinese = stability("spot-cutoff-0", "zh");
    EXPECT_NE(folder.read("out/stability.html").find("症状"), std::string::npos);
    EXPECT_NE(chinese.out.find("below a lamp whose cone has no width"), std::string::npos);
}

TEST_F(StabilityGl, RunsACaseFromAFileAndSaysWhenItsBoundIsBroken) {
    const std::string mine = R"({"group": "mine", "symptom": "s", "cause": "c", "source": "s", "scene": "point-light",
        "set": ["lights[0].diffuse=0.5"], "techniques": ["per-pixel/phong"], "bound": )";
    folder.write("wide.json", mine + "1e-4}");
    folder.write("narrow.json", mine + "1e-30}");
    const ProcessResult wide = stability(folder.file("wide.json"));
    EXPECT_EQ(wide.exit_code, 0) << wide.err << wide.out;
    EXPECT_EQ(nlohmann::json::parse(wide.out)["cases"][0]["name"], "wide");
    EXPECT_EQ(nlohmann::json::parse(wide.out)["cases"][0]["robust"].size(), 1U);
    EXPECT_EQ(stability(folder.file("narrow.json")).exit_code, 1);
}

} // namespace
} // namespace sandbox

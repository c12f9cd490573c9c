#include "teach/claims.h"

#include "scene/mesh_factor.h"
#include "teach/lesson_read.h"
#include "teach/lesson_report.h"
#include "tools/english.h"
#include "tools/error_of.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <nlohmann/json.hpp>

namespace sandbox {
namespace {

/// Pictures whose figures are known: grey by the technique's frequency and the scene's first diffuse intensity.
class Claims : public testing::Test {
  protected:
    /// What the picture of a technique is filled with: 0.5 per vertex, 0.25 per pixel, times the lamp.
    static float grey(const Scene &scene, const Technique &technique) {
        const double share = technique.frequency == Frequency::per_vertex ? 0.5 : 0.25;
        return static_cast<float>(share * scene.lights[0].diffuse);
    }
    LessonDraw draw() {
        return {[this](const Scene &scene) { return resources_.load(scene); },
                [this](const Scene &scene, const Technique &technique, Size size) {
                    Frame frame;
                    frame.color = Image(size, glm::vec4(glm::vec3(grey(scene, technique)), 1));
                    frame.color.pixels.front() = corner_;
                    frame.object_ids.assign(frame.color.pixels.size(), 1);
                    frame.milliseconds = technique.frequency == Frequency::per_vertex ? 1 : 4;
                    return frame;
                },
                &parts_};
    }
    /// One claim on a ball: A per vertex, B per pixel, the lamp's diffuse intensity 1.
    ClaimResult measure(const std::string &claim) {
        const Lesson lesson = parse_lesson(
            R"({"title": "t", "steps": [{"title": "t", "text": "x", "asserts": false, "scene":
                {"lights": [{"type": "point", "position": [0, 0, 4]}], "objects": [{"mesh": {"shape": "sphere"}}]},
                "left": "per-vertex/phong", "right": "per-pixel/phong", "claims": [)" +
                claim + "]}]}",
            "t.json", {}, Assets("assets"), {});
        return measure_step(lesson.steps[0], draw()).front();
    }
    double value(const std::string &claim) { return measure(claim).value; }

    glm::vec4 corner_{0.5, 0.5, 0.5, 1};

  private:
    Resources resources_{Assets("assets")};
    ShaderParts parts_{Assets("shaders")};
};

TEST_F(Claims, CompareTwoPicturesOrOneAndAColour) {
    EXPECT_EQ(value(R"({"metric": "max_abs", "against": "right", "below": 1})"), 0.25);
    EXPECT_EQ(value(R"({"metric": "max_abs", "of": "right", "against": [0.25, 0.25, 1], "below": 1,
                        "region": [0.5, 0, 1, 1]})"),
              0.75);
    EXPECT_EQ(value(R"({"metric": "max_abs", "of": "flat/phong", "against": "left", "below": 1})"), 0.25);
    EXPECT_EQ(value(R"({"metric": "max_abs", "against_set": ["lights[0].diffuse=0.5"], "against": "left", "below": 1,
                        "region": [0.5, 0, 1, 1]})"),
              0.25);
    EXPECT_EQ(value(R"({"metric": "brightest", "set": ["lights[0].diffuse=2"], "below": 1})"), 1);
    EXPECT_EQ(value(R"({"metric": "brightest", "than": "right", "region": [0.5, 0, 1, 1], "below": 1})"), 2);
}

TEST_F(Claims, ARegionLeavesOutTheRest) {
    corner_ = {9, 9, 9, 1};
    EXPECT_EQ(value(R"({"metric": "brightest", "below": 1})"), 9);
    EXPECT_EQ(value(R"({"metric": "brightest", "below": 1, "region": [0.01, 0, 1, 1]})"), 0.5);
    EXPECT_EQ(value(R"({"metric": "brightest", "below": 1, "region": [0, 0, 1e-9, 1e-9]})"), 9) << "one pixel";
}

TEST_F(Claims, CountBitsAndPixelsThatAreNotFinite) {
    EXPECT_EQ(value(R"({"metric": "differing_bits", "against": "left", "equals": 0})"), 0);
    EXPECT_EQ(value(R"({"metric": "differing_bits", "against": "right", "size": "4x3", "equals": 0})"), 11)
        << "all but the corner";
    EXPECT_EQ(value(R"({"metric": "nonfinite_pixels", "equals": 0})"), 0);
    corner_ = glm::vec4(std::numeric_limits<float>::quiet_NaN());
    EXPECT_EQ(value(R"({"metric": "nonfinite_pixels", "equals": 0})"), 1);
    EXPECT_FALSE(measure(R"({"metric": "brightest", "below": 1})").passed);
}

TEST_F(Claims, ABoundHoldsOrDoesNot) {
    const auto passed = [&](const std::string &bound) {
        return measure(R"({"metric": "max_abs", "against": "right", )" + bound + "}").passed;
    };
    EXPECT_TRUE(passed(R"("below": 0.26)") && passed(R"("above": 0.24)") && passed(R"("equals": 0.25)"));
    EXPECT_FALSE(passed(R"("below": 0.25)") || passed(R"("above": 0.25)") || passed(R"("equals": 0.2)"));
    EXPECT_TRUE(passed(R"("about": 0.2, "within": 1.3)") && passed(R"("about": 0.3, "within": 1.3)"));
    EXPECT_FALSE(passed(R"("about": 0.2, "within": 1.2)") || passed(R"("about": 0.35, "within": 1.3)"));
    EXPECT_EQ(measure(R"({"metric": "max_abs", "against": "right", "about": 0.2, "within": 1.3})").bound,
              "0.200 within a factor of 1.3");
    EXPECT_EQ(measure(R"({"metric": "max_abs", "against": "right", "below": 1})").what, "largest error: A against B");
}

TEST_F(Claims, AnOrderIsTheSlopeOverFinerMeshes) {
    // The truth in double and the mesh itself: how far the truth on a mesh is from the true ball falls with the square
    // of the mesh width (the sagitta of a chord), within a tenth at these widths.
    const double order = value(R"({"metric": "rmse", "of": "reference", "against": "analytic", "meshes": [1, 2, 4],
                                   "above": 1})");
    EXPECT_NEAR(order, 2, 0.2);
}

TEST_F(Claims, AMotionGivesTheLargestChangeBetweenMoments) {
    // The lamp goes from 0 to 1 in six moments: 1/6 each, and A shows half of it.
    const std::string motion = R"("motion": {"mover": "number", "path": "lights[0].diffuse", "from": 0, "to": 1,
        "seconds": 0.2, "course": "turn"}, "region": [0.5, 0, 1, 1])";
    EXPECT_NEAR(value(R"({"metric": "max_abs", "below": 1, )" + motion + "}"), 0.5 / 6, 1e-6);
    EXPECT_NEAR(value(R"({"metric": "max_abs", "below": 1, "than": "right", )" + motion + "}"), 2, 1e-5);
}

TEST_F(Claims, GlslHoldsWholeWordsOutsideComments) {
    const auto holds = [&](const std::string &words) { return measure("{" + words + "}").passed; };
    EXPECT_TRUE(holds(R"("of": "right", "has": ["pow", "v_normal"], "lacks": ["po", "normal", "textbook"])"));
    EXPECT_FALSE(holds(R"("of": "right", "has": ["pow", "texture"])"));
    EXPECT_TRUE(holds(R"("has": ["pow"], "stage": "vertex")"));
    EXPECT_FALSE(holds(R"("has": ["pow"], "stage": "fragment")")) << "A lights vertices";
    EXPECT_TRUE(holds(R"("of": "right", "lacks": ["Phong"])")) << "it stands in a comment";
    EXPECT_EQ(measure(R"({"of": "right", "has": ["pow", "texture"], "lacks": ["dot"]})").measured,
              "lacks texture, has dot");
    EXPECT_GT(value(R"({"metric": "glsl_lines", "below": 1})"), 20);
}

TEST_F(Claims, RunTimesAreShownAndNeverChecked) {
    const ClaimResult shown = measure(R"({"metric": "run_time", "of": "right", "than": "left"})");
    EXPECT_EQ(shown.value, 4);
    EXPECT_FALSE(shown.checked);
    EXPECT_TRUE(shown.passed);
    EXPECT_EQ(shown.bound, "");
}

TEST_F(Claims, TheTwinAndTheTextbookAreOfTheOtherPicturesTechnique) {
    // A is per vertex: in double it differs from the reference, which is per pixel, on a coarse ball; and from the
    // textbook's float32 of the same by rounding.
    const std::string coarse = R"("set": ["objects[0].mesh.rings=6", "objects[0].mesh.segments=12"])";
    EXPECT_GT(value(R"({"metric": "max_abs", "of": "twin", "below": 1, )" + coarse + "}"), 0.05);
    EXPECT_LT(value(R"({"metric": "max_abs", "of": "textbook", "against": "twin", "below": 1, )" + coarse + "}"), 1e-4);
}

TEST_F(Claims, TheReportSaysWhatFailed) {
    const ClaimResult good = measure(R"({"metric": "max_abs", "against": "right", "below": 1})");
    const ClaimResult bad =
        measure(R"({"says": "They are one.", "metric": "max_abs", "against": "right", "below": 0.1})");
    Lesson lesson;
    lesson.name = "mine";
    lesson.title.text = "Mine & yours";
    lesson.steps.resize(1);
    lesson.steps[0].title.text = "Step";
    lesson.steps[0].left = lesson.steps[0].right = Technique{};
    lesson.steps[0].question = {{"Why?"}, {"Because."}};
    const MeasuredLesson measured{lesson, {{{good, bad}}}};
    EXPECT_FALSE(measured.result.passed());
    const std::string table = lesson_table(measured);
    EXPECT_NE(table.find("ok     largest error: A against B: 0.250 linear colour (below 1.00)\n"), std::string::npos)
        << table;
    EXPECT_NE(table.find("FAILED They are one.: 0.250"), std::string::npos) << table;
    const auto json = nlohmann::json::parse(lessons_json({&measured, 1}, "r"));
    EXPECT_EQ(json["passed"], false);
    EXPECT_EQ(json["lessons"][0]["steps"][0]["claims"][1]["passed"], false);
    EXPECT_EQ(json["lessons"][0]["steps"][0]["claims"][0]["value"], 0.25);
    const std::vector<ByteImage> pictures{{{1, 1}, {1, 2, 3}}};
    const std::string page = lesson_html(english, measured, pictures, "r");
    EXPECT_NE(lessons_index(english, {&measured, 1}).find("<a href=\"mine.html\">Mine &amp; yours</a>"),
              std::string::npos);
    for (const char *part : {"<title>Mine &amp; yours</title>", "<details><summary>Why?</summary><p>Because.</p>",
                             "src=\"data:image/png;base64,", "does not hold", "id=\"step-1\""}) {
        EXPECT_NE(page.find(part), std::string::npos) << part;
    }
}

} // namespace
} // namespace sandbox

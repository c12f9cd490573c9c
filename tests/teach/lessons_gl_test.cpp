#include "teach/lesson_read.h"
#include "teach/lesson_report.h"

#include "render/renderer.h"
#include "tools/gl_test.h"

#include <map>
#include <set>

namespace sandbox {
namespace {

class LessonsOnTheRenderer : public GlTest {
  protected:
    Assets assets_{"assets"};
    Renderer renderer_{assets_, ShaderParts(Assets("shaders"))};
    LessonDraw draw_ = lessons_drawn_by(renderer_);
    std::vector<Lesson> lessons_ = builtin_lessons(assets_, words_in("en", assets_));
};

TEST_F(LessonsOnTheRenderer, NoLessonLies) {
    std::vector<Lesson> all = builtin_bugs(assets_, words_in("en", assets_));
    all.insert(all.end(), lessons_.begin(), lessons_.end());
    for (const Lesson &lesson : all) {
        const MeasuredLesson measured{lesson, measure_lesson(lesson, draw_)};
        EXPECT_TRUE(measured.result.passed()) << lesson_table(measured);
    }
}

/// The test above can fail: a claim that is false is found, and named.
TEST_F(LessonsOnTheRenderer, AFalseClaimIsFound) {
    const Lesson lesson = parse_lesson(R"({"title": "t", "steps": [{"title": "t", "text": "Per vertex is right.",
        "scene": "studio", "left": "per-vertex/phong", "claims": [
            {"metric": "max_abs", "above": 0.1, "size": "160x120"},
            {"says": "Per vertex is right", "metric": "max_abs", "below": 1e-3, "size": "160x120"}]}]})",
                                       "lie.json", {}, assets_, {});
    const MeasuredLesson measured{lesson, measure_lesson(lesson, draw_)};
    EXPECT_TRUE(measured.result.steps[0][0].passed);
    EXPECT_FALSE(measured.result.steps[0][1].passed);
    EXPECT_NE(lesson_table(measured).find("FAILED Per vertex is right"), std::string::npos);
}

} // namespace
} // namespace sandbox

#pragma once

#include "measure/metrics/metrics.h"
#include "scene/resources.h"
#include "shading/parts.h"
#include "teach/lesson.h"
#include "words/words.h"

#include <array>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

/// Measures what lessons claim. Knows no OpenGL.
namespace sandbox {

/// The words of PictureSource::Kind, but for a technique and a colour.
inline constexpr std::array<std::string_view, 6> picture_words{"left",     "right", "reference",
                                                               "analytic", "twin",  "textbook"};

/// The metrics of claims beside those of `compare`.
struct ClaimMetric {
    std::string_view name, unit, meaning;
};
constexpr std::string_view bits_metric = "differing_bits", brightest_metric = "brightest", lines_metric = "glsl_lines",
                           run_time_metric = "run_time";
inline constexpr ClaimMetric claim_metric_rows[]{
    {bits_metric, "pixels", "pixels that differ in any bit"},
    {brightest_metric, "linear colour", "brightest value"},
    {lines_metric, "lines", "lines of GLSL that are neither empty nor a comment alone"},
    {run_time_metric, "ms", "median run time of a frame"},
};
/// The names of all.
std::vector<std::string_view> claim_metrics();
bool is_claim_metric(std::string_view name);
/// The texts of those rows by key, as row_texts() has others.
std::map<std::string, std::string> claim_row_texts();

/// How a lesson is drawn: by the renderer, or by a fake in a test.
struct LessonDraw {
    std::function<std::vector<ObjectResources>(const Scene &)> load;
    /// With object ids, timed.
    std::function<Frame(const Scene &, const Technique &, Size)> picture;
    const ShaderParts *parts = nullptr;
    Words words = words_in(languages.front()); ///< of what is said of the claims
};

struct ClaimResult {
    std::string what;     ///< the claim, in words: "largest error of A against the truth"
    std::string measured; ///< "0.312"
    std::string bound;    ///< "above 0.3"; empty: none
    double value = 0;     ///< of words, how many are not as claimed
    std::string unit;
    bool checked = true;
    bool passed = true; ///< also where nothing is checked
};

/// A claim before it is measured: in words, with its bound.
ClaimResult claim_words(const Words &words, const LessonClaim &claim);
/// Hands each result to `ready` as soon as it is measured. Throws InputError if a technique is refused for the scene.
std::vector<ClaimResult> measure_step(const LessonStep &step, const LessonDraw &draw,
                                      const std::function<void(const ClaimResult &)> &ready = {});

struct LessonResult {
    std::vector<std::vector<ClaimResult>> steps;
    [[nodiscard]] std::vector<std::string> failed() const; ///< the claims, in words
    [[nodiscard]] bool passed() const { return failed().empty(); }
};
LessonResult measure_lesson(const Lesson &lesson, const LessonDraw &draw);

/// Draws with render/'s Renderer, which this room cannot name and which must outlive what is returned.
template <typename Renderer> LessonDraw lessons_drawn_by(Renderer &renderer) {
    return {[&](const Scene &scene) { return renderer.resources().load(scene); },
            [&](const Scene &scene, const Technique &technique, Size size) {
                return renderer.render(scene, technique, size, true);
            },
            &renderer.parts()};
}

} // namespace sandbox

#include "teach/claims.h"

#include "measure/report/text.h"
#include "scene/mesh_factor.h"
#include "shading/prepared_object.h"
#include "shading/program_source.h"
#include "teach/pictures.h"
#include "words/row_words.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <sstream>
#include <utility>

namespace sandbox {
namespace {

using Kind = PictureSource::Kind;

constexpr int timed_frames = 7;

std::string name_of(const Words &words, const PictureSource &source) {
    return source.kind == Kind::technique ? title_of(words, source.technique)
           : source.kind == Kind::color
               ? words.format("claim.colour", source.color.x, source.color.y, source.color.z)
               : words.text(fmt::format("claim.{}", picture_words[static_cast<std::size_t>(source.kind)]));
}

std::string claim_metric_key(const ClaimMetric &row) { return fmt::format("metric.{}", row.name); }

std::string motion_title(const Words &words, const Motion &motion) {
    const std::size_t number = motion.index + 1;
    return motion.mover == Mover::number   ? motion.path
           : motion.mover == Mover::camera ? words.text("motion.camera")
           : motion.mover == Mover::light  ? words.format("motion.light", number)
                                           : words.format("motion.object", number);
}

struct NamedMetric {
    std::string meaning, unit;
};
NamedMetric metric_of(const Words &words, std::string_view name) {
    NamedMetric found;
    for_each_metric(Metrics{}, [&](const auto &row, const auto &) {
        if (row.name == name) {
            found = {meaning_of(words, row), unit_title(words, row.unit)};
        }
    });
    for (const ClaimMetric &row : claim_metric_rows) {
        if (row.name == name) {
            found = {row_text(words, claim_metric_key(row), row.meaning), unit_title(words, row.unit)};
        }
    }
    return found;
}

/// The code of a GLSL text: without comments and empty lines.
std::string code_of(const std::string &glsl) {
    std::istringstream lines(glsl);
    std::string code;
    for (std::string line; std::getline(lines, line);) {
        line.resize(std::min(line.size(), line.find("//")));
        line.resize(line.find_last_not_of(" \t\r") + 1);
        code += line.empty() ? "" : line + "\n";
    }
    return code;
}

bool in_a_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Is `word` in the code, and no part of a longer word?
bool holds(const std::string &code, const std::string &word) {
    for (std::size_t at = code.find(word); at != std::string::npos; at = code.find(word, at + 1)) {
        const bool begins = at == 0 || !in_a_word(word.front()) || !in_a_word(code[at - 1]);
        const std::size_t end = at + word.size();
        const bool ends = end == code.size() || !in_a_word(word.back()) || !in_a_word(code[end]);
        if (begins && ends) {
            return true;
        }
    }
    return false;
}

/// One claim's measurement.
class Measurement {
  public:
    Measurement(const LessonStep &step, const LessonClaim &claim, const LessonDraw &draw, PictureShelf &shelf)
        : step_(step), claim_(claim), draw_(draw), shelf_(shelf) {}

    /// The code of every object's program.
    [[nodiscard]] std::string code(const PictureSource &of) const {
        const Technique technique = technique_of(of, step_, *step_.left);
        std::string all;
        for (const PreparedObject &object : prepare_objects(claim_.scene, technique, draw_.load(claim_.scene))) {
            const ProgramSource program = assemble(object.program, *draw_.parts);
            all += claim_.stage != "fragment" ? code_of(program.vertex.text) : "";
            all += claim_.stage != "vertex" ? code_of(program.fragment.text) : "";
        }
        return all;
    }

    [[nodiscard]] double value(const PictureSource &of) const {
        if (claim_.metric == lines_metric) {
            const std::string text = code(of);
            return static_cast<double>(std::ranges::count(text, '\n'));
        }
        if (claim_.motion) {
            return largest_change(of);
        }
        return claim_.meshes.empty() ? figure(of, 1) : order(of);
    }

    /// Of two pictures in turns, so that both meet the same machine.
    [[nodiscard]] std::pair<double, double> run_times(const PictureSource &of, const PictureSource &than) const {
        std::vector<double> first, second;
        for (int i = 0; i < timed_frames; ++i) {
            first.push_back(drawn_in(of));
            second.push_back(drawn_in(than));
        }
        const auto median = [](std::vector<double> &times) {
            std::ranges::nth_element(times, times.begin() + timed_frames / 2);
            return times[timed_frames / 2];
        };
        return {median(first), median(second)};
    }

  private:
    const LessonStep &step_;
    const LessonClaim &claim_;
    const LessonDraw &draw_;
    PictureShelf &shelf_;

    [[nodiscard]] double drawn_in(const PictureSource &of) const {
        const Scene scene = with_mesh_factor(claim_.scene, mesh_factor_of(of, step_, of));
        return draw_.picture(scene, technique_of(of, step_, *step_.left), claim_.size).milliseconds;
    }
    [[nodiscard]] Picture picture(const PictureSource &source, const PictureSource &other, const Technique &judged,
                                  const Scene &scene, double factor) const {
        const Scene meshed = with_mesh_factor(scene, mesh_factor_of(source, step_, other) * factor);
        const Technique technique = technique_of(source, step_, judged);
        return cropped(shelf_.picture(source, technique, meshed, claim_.size), claim_.region);
    }
    [[nodiscard]] PictureSource judge() const {
        const bool alone = claim_.metric == brightest_metric || claim_.metric == "nonfinite_pixels";
        return claim_.against.value_or(alone ? claim_.of : PictureSource{Kind::reference});
    }
    /// The metric of two pictures.
    [[nodiscard]] double compared(const Picture &of, const Picture &against) const {
        if (claim_.metric == bits_metric) {
            return static_cast<double>(differing_bits(of, against));
        }
        double value = unmeasured;
        const Metrics metrics = compare_pictures(of, against, claim_.metric == "flip" ? Flip::with : Flip::without);
        for_each_metric(metrics, [&](const auto &row, const auto &measured) {
            if (row.name == claim_.metric) {
                value = row.value(measured).value_or(std::numeric_limits<double>::infinity()); // of psnr: the same
            }
        });
        return value;
    }
    [[nodiscard]] double figure(const PictureSource &of, double factor) const {
        const Technique technique = technique_of(of, step_, *step_.left);
        const Picture own = picture(of, of, technique, claim_.scene, factor);
        if (claim_.metric == brightest_metric) {
            return brightest(own);
        }
        return compared(own, picture(judge(), of, technique, claim_.against_scene, factor));
    }
    /// The slope of log(figure) over log(1 / mesh factor), least squares.
    [[nodiscard]] double order(const PictureSource &of) const {
        double x_sum = 0, y_sum = 0, xx = 0, xy = 0;
        for (const double factor : claim_.meshes) {
            const double x = -std::log(factor), y = std::log(figure(of, factor));
            x_sum += x, y_sum += y, xx += x * x, xy += x * y;
        }
        const auto n = static_cast<double>(claim_.meshes.size());
        return (n * xy - x_sum * y_sum) / (n * xx - x_sum * x_sum);
    }
    [[nodiscard]] double largest_change(const PictureSource &of) const {
        const Technique technique = technique_of(of, step_, *step_.left);
        double largest = 0;
        Picture last = picture(of, of, technique, moved(claim_.scene, *claim_.motion, 0), 1);
        for (int moment = 1; moment < moments_of(*claim_.motion); ++moment) {
            Picture now = picture(of, of, technique, moved(claim_.scene, *claim_.motion, moment), 1);
            largest = std::max(largest, compared(now, last));
            last = std::move(now);
        }
        return largest;
    }
};

std::string list_of(const std::vector<std::string> &words) { return fmt::format("{}", fmt::join(words, ", ")); }
std::string settings_text(const Words &words, const std::vector<std::string> &settings) {
    const std::string list = list_of(settings);
    return list.size() <= 70 ? list : words.format("claim.settings", settings.size());
}

/// The claim in the words of its metric.
std::string said(const Words &words, const LessonClaim &claim) {
    const std::string of = name_of(words, claim.of);
    if (claim.metric.empty()) {
        std::vector<std::string> parts;
        if (!claim.has.empty()) {
            parts.push_back(words.format("claim.has", list_of(claim.has)));
        }
        if (!claim.lacks.empty()) {
            parts.push_back(words.format("claim.lacks", list_of(claim.lacks)));
        }
        const std::string stage = claim.stage.empty() ? "" : words.text("claim.stage." + claim.stage);
        return words.format("claim.glsl", of, stage, fmt::join(parts, words.text("technique.and")));
    }
    std::string text = metric_of(words, claim.metric).meaning;
    const bool alone = claim.metric == brightest_metric || claim.metric == lines_metric ||
                       claim.metric == run_time_metric || (claim.metric == "nonfinite_pixels" && !claim.against);
    if (claim.motion) {
        text = words.format("claim.moments", text, motion_title(words, *claim.motion), of);
    } else {
        const PictureSource against = claim.against.value_or(PictureSource{Kind::reference});
        text = alone ? words.format("claim.alone", text, of)
                     : words.format("claim.against", text, of, name_of(words, against));
    }
    text += claim.against_set.empty() ? "" : words.format("claim.against_set", settings_text(words, claim.against_set));
    text += claim.meshes.empty() ? "" : words.text("claim.order");
    text += claim.than ? words.format("claim.than", name_of(words, *claim.than)) : "";
    text += claim.set.empty() ? "" : words.format("claim.set", settings_text(words, claim.set));
    return text + (claim.region ? words.text("claim.region") : "");
}

std::string bound_words(const Words &words, const LessonClaim &claim) {
    return claim.below    ? words.format("claim.below", short_number(*claim.below))
           : claim.above  ? words.format("claim.above", short_number(*claim.above))
           : claim.equals ? words.format("claim.equals", short_number(*claim.equals))
           : claim.about  ? words.format("claim.about", short_number(*claim.about), claim.within)
                          : "";
}

/// No comparison holds of NaN.
bool holds(const LessonClaim &claim, double value) {
    return claim.below    ? value < *claim.below
           : claim.above  ? value > *claim.above
           : claim.equals ? value == *claim.equals
           : claim.about  ? value >= *claim.about / claim.within && value <= *claim.about * claim.within
                          : true;
}

void measure_words(const Words &words, const LessonClaim &claim, const Measurement &measurement, ClaimResult &result) {
    const std::string code = measurement.code(claim.of);
    std::vector<std::string> wrong;
    for (const bool wanted : {true, false}) {
        for (const std::string &word : wanted ? claim.has : claim.lacks) {
            if (holds(code, word) != wanted) {
                wrong.push_back(words.format(wanted ? "claim.lacks" : "claim.has", word));
            }
        }
    }
    result.value = static_cast<double>(wrong.size());
    result.passed = wrong.empty();
    result.measured = wrong.empty() ? words.text("claim.so") : list_of(wrong);
}

void measure_run_time(const Words &words, const LessonClaim &claim, const Measurement &measurement,
                      ClaimResult &result) {
    const auto [first, second] = measurement.run_times(claim.of, claim.than.value_or(claim.of));
    result.value = claim.than ? first / second : first;
    result.measured =
        claim.than ? words.format("claim.times", milliseconds_text(first), milliseconds_text(second), result.value)
                   : words.format("claim.time", milliseconds_text(first));
}

void measure_metric(const Words &words, const LessonClaim &claim, const Measurement &measurement, ClaimResult &result) {
    result.value = measurement.value(claim.of);
    if (claim.than) {
        result.value /= measurement.value(*claim.than);
    }
    result.measured = short_number(words, result.value);
    result.passed = holds(claim, result.value);
}

} // namespace

bool LessonClaim::checked() const { return metric != run_time_metric; }

std::vector<std::string_view> claim_metrics() {
    std::vector<std::string_view> names;
    for_each_metric(Metrics{}, [&](const auto &row, const auto &) { names.push_back(row.name); });
    for (const ClaimMetric &row : claim_metric_rows) {
        names.push_back(row.name);
    }
    return names;
}

std::map<std::string, std::string> claim_row_texts() {
    std::map<std::string, std::string> texts;
    for (const ClaimMetric &row : claim_metric_rows) {
        texts.emplace(claim_metric_key(row), row.meaning);
        if (!row.unit.empty()) {
            texts.emplace(fmt::format("unit.{}", row.unit), row.unit);
        }
    }
    return texts;
}

bool is_claim_metric(std::string_view name) {
    const auto names = claim_metrics();
    return std::ranges::find(names, name) != names.end();
}

ClaimResult claim_words(const Words &words, const LessonClaim &claim) {
    ClaimResult result;
    result.what = claim.says.text.empty() ? spaced(words, said(words, claim)) : claim.says.text;
    result.bound = bound_words(words, claim);
    result.checked = claim.checked();
    result.unit = claim.metric.empty()                  ? words.text("claim.words")
                  : claim.than || !claim.meshes.empty() ? ""
                                                        : metric_of(words, claim.metric).unit;
    return result;
}

std::vector<ClaimResult> measure_step(const LessonStep &step, const LessonDraw &draw,
                                      const std::function<void(const ClaimResult &)> &ready) {
    PictureShelf shelf(draw);
    std::vector<ClaimResult> results;
    for (const LessonClaim &claim : step.claims) {
        const Measurement measurement(step, claim, draw, shelf);
        ClaimResult result = claim_words(draw.words, claim);
        const auto measure = claim.metric.empty()              ? measure_words
                             : claim.metric == run_time_metric ? measure_run_time
                                                               : measure_metric;
        measure(draw.words, claim, measurement, result);
        if (ready) {
            ready(result);
        }
        results.push_back(std::move(result));
    }
    return results;
}

std::vector<std::string> LessonResult::failed() const {
    std::vector<std::string> words;
    for (const auto &claims : steps) {
        for (const ClaimResult &claim : claims) {
            if (!claim.passed) {
                words.push_back(claim.what);
            }
        }
    }
    return words;
}

LessonResult measure_lesson(const Lesson &lesson, const LessonDraw &draw) {
    LessonResult result;
    for (const LessonStep &step : lesson.steps) {
        result.steps.push_back(measure_step(step, draw));
    }
    return result;
}

} // namespace sandbox

#include "teach/lesson_read.h"

#include "image/file_io.h"
#include "image/thread.h"
#include "scene/read_json.h"
#include "scene/scene_file.h"
#include "scene/scene_setting.h"
#include "teach/claims.h"
#include "teach/files/scene_source.h"
#include "teach/files/taught_file.h"
#include "teach/files/text_read.h"
#include "teach/lesson_format.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

namespace sandbox {
namespace fs = std::filesystem;
namespace {

using nlohmann::json;

constexpr std::string_view lessons_folder = "lessons/", bugs_folder = "gallery/";
static_assert(overlay_kinds.size() == 5, "format_of<LessonStep> has a row for each");

class LessonReader : public TextReader<LessonReader, json> {
  public:
    LessonReader(const std::string &file, const Words &words) : TextReader(file, words) {}

  private:
    friend TableReader<LessonReader, json>;

    using TextReader::finish;
    using TextReader::read;

    void read(const json &json, const std::string &path, const Range &, PictureSource &out) const {
        if (json.is_array()) {
            out.kind = PictureSource::Kind::color;
            read(json, path, linear_rgb, out.color);
            return;
        }
        expect(json.is_string(), path, "left, right, reference, analytic, twin, textbook, a technique or [r, g, b]",
               json);
        const auto &word = json.get_ref<const std::string &>();
        const auto named = std::ranges::find(picture_words, word);
        out.kind = static_cast<PictureSource::Kind>(named - picture_words.begin());
        if (named == picture_words.end()) {
            read(json, path, any, out.technique);
            out.kind = PictureSource::Kind::technique;
        }
    }

    void finish(const json &json, const std::string &path, LessonClaim &claim) const {
        const auto refuse_claim = [&](const std::string &key, const std::string &what) {
            refuse(json.contains(key) ? below(path, key) : path, what);
        };
        const bool words = json.contains("has") || json.contains("lacks");
        if (words == json.contains("metric")) {
            refuse_claim("metric", "expected metric, or has and lacks");
        }
        if (!words && !is_claim_metric(claim.metric)) {
            refuse_claim("metric", fmt::format("unknown metric{}{}", got(json["metric"]),
                                               suggestion(claim.metric, claim_metrics())));
        }
        if (!claim.stage.empty() && claim.stage != "vertex" && claim.stage != "fragment") {
            refuse_claim("stage", R"(expected "vertex" or "fragment")" + got(json["stage"]));
        }
        const auto bounds = std::ranges::count_if(std::array{"below", "above", "equals", "about"},
                                                  [&](const char *key) { return json.contains(key); });
        if (bounds != (words || claim.metric == run_time_metric ? 0 : 1)) {
            refuse(path, words                             ? "expected no bound beside has and lacks"
                         : claim.metric == run_time_metric ? "expected no bound: a run time is shown, never checked"
                                                           : "expected one of below, above, equals, about");
        }
        if (json.contains("about") != json.contains("within")) {
            refuse(path, "expected about and within together");
        }
        if (json.contains("meshes") &&
            (claim.meshes.size() < 2 || !std::ranges::is_sorted(claim.meshes, std::less_equal<>()))) {
            refuse_claim("meshes", "expected two mesh factors or more, ascending" + got(json["meshes"]));
        }
        if (claim.region && !(claim.region->x < claim.region->z && claim.region->y < claim.region->w)) {
            refuse_claim("region", "expected left < right and top < bottom" + got(json["region"]));
        }
        if (!claim.motion_json.json.empty()) {
            claim.motion = parse_motion(claim.motion_json.json, fmt::format("{}: {}", name(), path));
        }
    }
    void finish(const json &json, const std::string &path, LessonStep &step) const {
        const bool checked = std::ranges::any_of(step.claims, &LessonClaim::checked);
        if (step.asserts && !checked) {
            refuse(below(path, "claims"), R"(expected a claim that is checked, or "asserts": false)");
        }
        if (step.tab.size() > 1) {
            refuse(below(path, "tab"), "expected the key of a tab, one letter" + got(json["tab"]));
        }
    }
    void finish(const json &json, const std::string &path, Lesson &lesson) const {
        expect(!lesson.steps.empty(), below(path, "steps"), "one step or more", json["steps"]);
        for (const char *key : {"seen", "cure", "source"}) {
            if (lesson.is_bug() != json.contains(key)) {
                refuse(below(path, key), "expected seen, cure and source together");
            }
        }
    }
};

/// What a step takes over from the step before it: its scene and its techniques.
class Resolver {
  public:
    Resolver(std::string file, fs::path folder, const Assets &assets)
        : file_(std::move(file)), folder_(std::move(folder)), assets_(assets) {}

    void resolve(std::vector<LessonStep> &steps) const {
        for (std::size_t i = 0; i < steps.size(); ++i) {
            const std::string place = fmt::format("{}: steps[{}]", file_, i);
            const LessonStep *last = i > 0 ? &steps[i - 1] : nullptr;
            LessonStep &step = steps[i];
            step.scene = scene(step, last, place);
            for (const auto member : {&LessonStep::left, &LessonStep::right}) {
                step.*member = step.*member ? step.*member : last != nullptr ? last->*member : Technique{};
            }
            for (std::size_t k = 0; k < step.claims.size(); ++k) {
                resolve_claim(step, step.claims[k], fmt::format("{}.claims[{}]", place, k));
            }
        }
    }

  private:
    std::string file_;
    fs::path folder_;
    const Assets &assets_;

    [[nodiscard]] Scene scene(const LessonStep &step, const LessonStep *last, const std::string &place) const {
        if (step.scene_json.json.empty() && last == nullptr) {
            throw InputError("{}.scene: missing; expected a scene: there is no step before this one", place);
        }
        Scene scene = step.scene_json.json.empty() ? last->scene
                                                   : scene_from(step.scene_json, place + ".scene", folder_, assets_);
        if (!step.camera_json.json.empty()) {
            const json camera = json::parse(step.camera_json.json);
            const std::string setting = "camera=" + step.camera_json.json;
            scene = camera.is_string()
                        ? at(place + ".camera", [&] { return with_view(scene, camera.get<std::string>()); })
                        : with_settings(scene, {&setting, 1}, place, folder_);
        }
        return step.set.empty() ? scene : with_settings(scene, step.set, place + ".set", folder_);
    }
    void resolve_claim(const LessonStep &step, LessonClaim &claim, const std::string &place) const {
        const auto changed = [&](const Scene &scene, const std::vector<std::string> &set, const char *key) {
            return set.empty() ? scene : with_settings(scene, set, place + key, folder_);
        };
        claim.scene = changed(step.scene, claim.set, ".set");
        claim.against_scene = changed(claim.scene, claim.against_set, ".against_set");
        if (claim.motion) {
            at(place, [&] { return moved(claim.scene, *claim.motion, 0); }); // is there such a thing?
        }
    }
};

/// `file`: below assets/.
Lesson builtin_lesson(const std::string &file, const Assets &assets, const Words &words) {
    const fs::path folder = assets.folder().empty() ? fs::path() : (assets.folder() / file).parent_path();
    return parse_lesson(assets.read(file).value_or(""), file, folder, assets, words);
}

std::vector<Lesson> lessons_in(std::string_view folder, const Assets &assets, const Words &words) {
    std::vector<Lesson> lessons;
    for (const std::string &file : assets.list(folder)) {
        let_others_run();
        lessons.push_back(builtin_lesson(file, assets, words));
    }
    std::ranges::stable_sort(lessons, {}, &Lesson::order);
    return lessons;
}

} // namespace

Lesson parse_lesson(std::string_view text, const fs::path &file, const fs::path &folder, const Assets &assets,
                    const Words &words) {
    const json parsed = read_json<json>(text, file.string());
    Lesson lesson;
    LessonReader(file.string(), words).read_object(parsed, "", lesson, "$schema"); // which is for editors
    lesson.name = file.stem().string();
    Resolver(file.string(), folder, assets).resolve(lesson.steps);
    return lesson;
}

std::vector<Lesson> builtin_lessons(const Assets &assets, const Words &words) {
    return lessons_in(lessons_folder, assets, words);
}

std::vector<Lesson> builtin_bugs(const Assets &assets, const Words &words) {
    return lessons_in(bugs_folder, assets, words);
}

Lesson open_lesson(const std::string &name_or_file, const Assets &assets, const Words &words) {
    const fs::path path(name_or_file);
    if (names_file(path)) {
        return parse_lesson(read_file(path, largest_json), path, fs::absolute(path).parent_path(), assets, words);
    }
    return builtin_lesson(builtin_file(name_or_file, {lessons_folder, bugs_folder}, assets, "lesson"), assets, words);
}

} // namespace sandbox

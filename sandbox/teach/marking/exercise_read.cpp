#include "teach/marking/exercise_read.h"

#include "image/file_io.h"
#include "scene/read_json.h"
#include "scene/scene_file.h"
#include "scene/scene_setting.h"
#include "teach/files/scene_source.h"
#include "teach/files/taught_file.h"
#include "teach/files/text_read.h"
#include "teach/marking/exercise_format.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace sandbox {
namespace fs = std::filesystem;
namespace {

using nlohmann::json;

constexpr std::string_view exercises_folder = "exercises/";
constexpr int most_pixels = 512 * 512; ///< of a picture that is marked: a class of 200 waits for it

class ExerciseReader : public TextReader<ExerciseReader, json> {
  public:
    ExerciseReader(const std::string &file, const Words &words) : TextReader(file, words) {}

  private:
    friend TableReader<ExerciseReader, json>;

    using TextReader::finish;
    using TextReader::read;

    void finish(const json &json, const std::string &path, Exercise &exercise) const {
        const Technique &target = exercise.target;
        const bool taken = target.frequency == Frequency::flat || target.frequency == Frequency::per_vertex ||
                           target.frequency == Frequency::per_pixel;
        if (!taken || target != Technique{.frequency = target.frequency, .model = target.model}) {
            refuse(below(path, "target"),
                   "expected flat, per-vertex or per-pixel with a model and no keys" + got(json["target"]));
        }
        if (exercise.size.width * exercise.size.height > most_pixels) {
            refuse(below(path, "size"), fmt::format("expected at most {} pixels", most_pixels) + got(json["size"]));
        }
        const auto &scenes = exercise.scenes;
        if (scenes.empty() || scenes.front().withheld || scenes.front().stiff) {
            refuse(below(path, "scenes"), "expected one scene or more, the first neither withheld nor stiff");
        }
        expect(!exercise.terms.empty(), below(path, "terms"), "one term or more", json["terms"]);
        for (std::size_t i = 0; i < exercise.terms.size(); ++i) {
            if (exercise.find(exercise.terms[i].term) != &exercise.terms[i]) {
                refuse(element(below(path, "terms"), i), "expected each term once");
            }
        }
        const bool stiff = std::ranges::any_of(scenes, &ExerciseScene::stiff);
        if (stiff != (exercise.find(MarkTerm::robustness) != nullptr)) {
            refuse(below(path, "terms"), "expected robustness where a scene is stiff, and only there");
        }
    }
};

void resolve(Exercise &exercise, const std::string &file, const fs::path &folder, const Assets &assets) {
    for (std::size_t i = 0; i < exercise.scenes.size(); ++i) {
        const std::string place = fmt::format("{}: scenes[{}]", file, i);
        ExerciseScene &scene = exercise.scenes[i];
        if (scene.scene_json.json.empty() && i == 0) {
            throw InputError("{}.scene: missing; expected a scene: there is none before this one", place);
        }
        scene.scene = scene.scene_json.json.empty() ? exercise.scenes.front().scene
                                                    : scene_from(scene.scene_json, place + ".scene", folder, assets);
        if (!scene.set.empty()) {
            scene.scene = with_settings(scene.scene, scene.set, place + ".set", folder);
        }
        if (scene.name.empty()) {
            scene.name = std::to_string(i + 1);
        }
    }
}

/// `file`: below assets/.
Exercise builtin_exercise(const std::string &file, const Assets &assets, const Words &words) {
    const fs::path folder = assets.folder().empty() ? fs::path() : (assets.folder() / file).parent_path();
    return parse_exercise(assets.read(file).value_or(""), file, folder, assets, words);
}

} // namespace

double Exercise::points() const {
    double sum = 0;
    for (const TermPoints &term : terms) {
        sum += term.points;
    }
    return sum;
}

MarkTerms Exercise::asked() const {
    MarkTerms asked;
    for (const TermPoints &term : terms) {
        asked.insert(term.term);
    }
    return asked;
}

const TermPoints *Exercise::find(MarkTerm term) const {
    const auto found = std::ranges::find(terms, term, &TermPoints::term);
    return found == terms.end() ? nullptr : &*found;
}

Exercise parse_exercise(std::string_view text, const fs::path &file, const fs::path &folder, const Assets &assets,
                        const Words &words) {
    const json parsed = read_json<json>(text, file.string());
    Exercise exercise;
    ExerciseReader(file.string(), words).read_object(parsed, "", exercise, "$schema"); // which is for editors
    exercise.name = file.stem().string();
    resolve(exercise, file.string(), folder, assets);
    return exercise;
}

std::vector<Exercise> builtin_exercises(const Assets &assets, const Words &words) {
    std::vector<Exercise> exercises;
    for (const std::string &file : assets.list(exercises_folder)) {
        exercises.push_back(builtin_exercise(file, assets, words));
    }
    std::ranges::stable_sort(exercises, {}, &Exercise::order);
    return exercises;
}

Exercise open_exercise(const std::string &name_or_file, const Assets &assets, const Words &words) {
    const fs::path path(name_or_file);
    if (names_file(path)) {
        return parse_exercise(read_file(path, largest_json), path, fs::absolute(path).parent_path(), assets, words);
    }
    return builtin_exercise(builtin_file(name_or_file, {exercises_folder}, assets, "exercise"), assets, words);
}

std::string student_copy(const Exercise &exercise) {
    using nlohmann::ordered_json;
    ordered_json scenes = ordered_json::array(), terms = ordered_json::array();
    bool stiff = false;
    for (const ExerciseScene &scene : exercise.scenes) {
        if (!scene.withheld) {
            ordered_json json{{"name", scene.name}, {"scene", ordered_json::parse(scene_text(scene.scene))}};
            if (scene.stiff) {
                json["stiff"] = stiff = true;
            }
            scenes.push_back(std::move(json));
        }
    }
    for (const TermPoints &term : exercise.terms) {
        if (term.term != MarkTerm::robustness || stiff) {
            terms.push_back({{"term", term_words[static_cast<std::size_t>(term.term)]},
                             {"points", term.points},
                             {"tolerance", term.tolerance}});
        }
    }
    const ordered_json copy{{"title", exercise.title.text},
                            {"about", exercise.about.text},
                            {"task", exercise.task.text},
                            {"target", to_string(exercise.target)},
                            {"has", exercise.has},
                            {"lacks", exercise.lacks},
                            {"size", fmt::format("{}x{}", exercise.size.width, exercise.size.height)},
                            {"scenes", std::move(scenes)},
                            {"terms", std::move(terms)}};
    return copy.dump(2) + "\n";
}

} // namespace sandbox

#include "commands/commands.h"

#include "measure/stability/cases.h"
#include "scene/scene_file.h"
#include "shading/technique.h"
#include "teach/lesson_read.h"
#include "teach/marking/exercise_read.h"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace sandbox {
namespace {

using nlohmann::ordered_json;

ordered_json list_scenes(const Assets &assets) {
    ordered_json scenes = ordered_json::array();
    for (const std::string &name : builtin_scenes(assets)) {
        const Scene scene = open_scene(name, assets);
        scenes.push_back(
            {{"name", name}, {"title", scene.name}, {"description", scene.description}, {"source", scene.source}});
    }
    return scenes;
}

ordered_json list_lessons(const std::vector<Lesson> &all) {
    ordered_json lessons = ordered_json::array();
    for (const Lesson &lesson : all) {
        lessons.push_back({{"name", lesson.name}, {"title", lesson.title.text}, {"about", lesson.about.text}});
        if (lesson.is_bug()) {
            lessons.back()["source"] = lesson.source;
        }
    }
    return lessons;
}

ordered_json list_exercises(const std::vector<Exercise> &all) {
    ordered_json exercises = ordered_json::array();
    for (const Exercise &exercise : all) {
        exercises.push_back({{"name", exercise.name},
                             {"title", exercise.title.text},
                             {"about", exercise.about.text},
                             {"target", to_string(exercise.target)},
                             {"points", exercise.points()}});
    }
    return exercises;
}

ordered_json list_values(const TechniqueKey &key) {
    ordered_json values = ordered_json::array();
    for (const TechniqueValue &value : key.values) {
        values.push_back({{"name", value.name}, {"doc", value.look_for}});
    }
    return values;
}

ordered_json list_techniques() {
    ordered_json techniques{{"frequencies", list_values(frequency_key)},
                            {"models", list_values(model_key)},
                            {"tolerance", tolerance_doc},
                            {"keys", ordered_json::array()}};
    for (const TechniqueKey &key : technique_settings) {
        techniques["keys"].push_back(
            {{"name", key.name}, {"doc", key.doc}, {"fault", key.is_fault()}, {"values", list_values(key)}});
    }
    return techniques;
}

ordered_json list_stability_cases(const Assets &assets) {
    ordered_json cases = ordered_json::array();
    for (const StabilityCase &c : stability_cases(assets)) {
        cases.push_back({{"name", c.name}, {"group", c.group}, {"doc", c.symptom}, {"cause", c.cause}});
    }
    return cases;
}

/// A row for each name and its text, the names in a column.
std::string table(const ordered_json &rows, const char *text_key, int indent) {
    std::size_t widest = 0;
    for (const ordered_json &row : rows) {
        widest = std::max(widest, row["name"].get<std::string>().size());
    }
    std::string out;
    for (const ordered_json &row : rows) {
        out += fmt::format("{:{}}{:{}}  {}\n", "", indent, row["name"].get<std::string>(), widest,
                           row[text_key].get<std::string>());
    }
    return out;
}

std::string human_text(const ordered_json &all) {
    const auto section = [](std::string_view title, const std::string &rows) {
        return fmt::format("{}\n{}\n", title, rows.empty() ? "  (none)\n" : rows);
    };
    const ordered_json &techniques = all["techniques"];
    std::string out = section("Scenes", table(all["scenes"], "description", 2)) +
                      section("Lessons", table(all["lessons"], "title", 2)) +
                      section("Famous bugs", table(all["bugs"], "about", 2)) +
                      section("Exercises", table(all["exercises"], "about", 2)) +
                      "Techniques: FREQUENCY/MODEL[:key=value[,key=value]], the first value of a key is its default\n" +
                      section("  Frequencies", table(techniques["frequencies"], "doc", 4)) +
                      section("  Models", table(techniques["models"], "doc", 4)) +
                      fmt::format("  Keys\n    {}: {}\n", tolerance_name, tolerance_doc);
    for (const ordered_json &key : techniques["keys"]) {
        out += fmt::format("    {}: {}\n{}", key["name"].get<std::string>(), key["doc"].get<std::string>(),
                           table(key["values"], "doc", 6));
    }
    return out + "\n" + section("Stability cases", table(all["stability"], "doc", 2));
}

struct ListFlags {
    bool json = false;
};

int run_list(const ListFlags &flags, const CommonOptions &common) {
    refuse_settings(common, "list opens no scene");
    const Assets assets = scene_assets(common);
    const Words words = words_in(languages.front(), assets);
    const ordered_json all{{"version", SANDBOX_VERSION},
                           {"scenes", list_scenes(assets)},
                           {"lessons", list_lessons(builtin_lessons(assets, words))},
                           {"bugs", list_lessons(builtin_bugs(assets, words))},
                           {"exercises", list_exercises(builtin_exercises(assets, words))},
                           {"techniques", list_techniques()},
                           {"stability", list_stability_cases(assets)}};
    print(flags.json ? all.dump(2) + "\n" : human_text(all));
    return 0;
}

} // namespace

void add_list_options(CLI::App &command, CommonOptions &common, Run &run) {
    const auto flags = std::make_shared<ListFlags>();
    command.add_flag("--json", flags->json, "Print JSON");
    run_when_chosen(command, common, run, flags, run_list);
}

} // namespace sandbox

#include "commands/commands.h"

#include "measure/stability/cases.h"
#include "scene/scene_file.h"
#include "shading/technique.h"

#include <memory>
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

ordered_json list_lessons(const Assets &assets) {
    ordered_json lessons = ordered_json::array();
    for (const std::string &path : assets.list("lessons/")) {
        const ordered_json lesson = ordered_json::parse(assets.read(path).value_or(""), nullptr, false);
        const std::string title =
            lesson.is_object() && lesson.contains("title") && lesson["title"].is_string() ? lesson["title"] : "";
        lessons.push_back({{"name", std::filesystem::path(path).stem().string()}, {"title", title}});
    }
    return lessons;
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
                            {"keys", ordered_json::array()}};
    for (const TechniqueKey &key : technique_settings) {
        techniques["keys"].push_back(
            {{"name", key.name}, {"doc", key.doc}, {"fault", key.is_fault()}, {"values", list_values(key)}});
    }
    return techniques;
}

ordered_json list_stability_cases(const Assets &assets) {
    ordered_json cases = ordered_json::array();
    for (const StabilityCase &one : stability_cases(assets)) {
        cases.push_back({{"name", one.name}, {"group", one.group}, {"doc", one.symptom}, {"cause", one.cause}});
    }
    return cases;
}

/// One row a name and what it is, the names in a column.
std::string table(const ordered_json &rows, const char *text_key, int indent) {
    std::size_t widest = 0;
    for (const ordered_json &row : rows) {
        widest = std::max(widest, row["name"].get<std::string>().size());
    }
    std::string out;
    for (const ordered_json &row : rows) {
        const auto name = row["name"].get<std::string>();
        out += std::string(static_cast<std::size_t>(indent), ' ') + name + std::string(widest - name.size() + 2, ' ') +
               row[text_key].get<std::string>() + "\n";
    }
    return out;
}

std::string human_text(const ordered_json &all) {
    const auto section = [](const std::string &title, const std::string &rows) {
        return title + "\n" + (rows.empty() ? "  (none)\n" : rows) + "\n";
    };
    std::string out = section("Scenes", table(all["scenes"], "description", 2)) +
                      section("Lessons", table(all["lessons"], "title", 2)) +
                      "Techniques: FREQUENCY/MODEL[:key=value[,key=value]], the first value of a key is its default\n" +
                      section("  Frequencies", table(all["techniques"]["frequencies"], "doc", 4)) +
                      section("  Models", table(all["techniques"]["models"], "doc", 4)) + "  Keys\n";
    for (const ordered_json &key : all["techniques"]["keys"]) {
        out += "    " + key["name"].get<std::string>() + ": " + key["doc"].get<std::string>() + "\n" +
               table(key["values"], "doc", 6);
    }
    return out + "\n" + section("Stability cases", table(all["stability"], "doc", 2));
}

int run_list(bool json, const CommonOptions &common) {
    const Assets assets = scene_assets(common);
    const ordered_json all{{"version", SANDBOX_VERSION},
                           {"scenes", list_scenes(assets)},
                           {"lessons", list_lessons(assets)},
                           {"techniques", list_techniques()},
                           {"stability", list_stability_cases(assets)}};
    print(json ? all.dump(2) + "\n" : human_text(all));
    return 0;
}

} // namespace

void add_list(CLI::App &app, CommonOptions &common, Run &run) {
    CLI::App *command = app.add_subcommand("list", "Built-in scenes, lessons, techniques, stability cases");
    auto json = std::make_shared<bool>(false);
    command->add_flag("--json", *json, "As JSON");
    add_common_options(*command, common);
    command->callback([json, &common, &run] { run = [json, &common] { return run_list(*json, common); }; });
}

} // namespace sandbox

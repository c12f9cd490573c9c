#include "measure/stability/cases.h"

#include "image/error.h"
#include "image/image_file.h"
#include "image/thread.h"
#include "scene/read_json.h"
#include "scene/scene_file.h"
#include "scene/scene_setting.h"
#include "scene/suggest.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>

namespace sandbox {
namespace fs = std::filesystem;
namespace {

using nlohmann::json;

constexpr std::string_view cases_folder = "stability/cases/";
constexpr double one_level = 1.0 / 255;
constexpr std::array<std::string_view, 12> known_keys{"group",    "symptom",         "cause", "source",
                                                      "seen_on",  "scene",           "set",   "techniques",
                                                      "textbook", "textbook_target", "bound", "unit"};

class CaseReader {
  public:
    CaseReader(std::string file, fs::path folder, const Assets &assets)
        : file_(std::move(file)), folder_(std::move(folder)), assets_(assets) {}

    StabilityCase read(std::string_view text) {
        json_ = read_json<json>(text, file_);
        if (!json_.is_object()) {
            throw InputError("{}: expected an object, got {}", file_, short_json(json_));
        }
        for (const auto &[key, value] : json_.items()) {
            if (std::ranges::find(known_keys, key) == known_keys.end()) {
                throw InputError("{}: {}: unknown key of a stability case{}", file_, key.substr(0, 60),
                                 suggestion(key, known_keys));
            }
        }
        const json usual{"per-pixel/blinn-phong", "per-pixel/phong", "per-pixel/blinn-phong:program=full",
                         "per-vertex/blinn-phong"}; // where most equations run
        StabilityCase read;
        read.name = fs::path(file_).stem().string();
        read.group = words("group");
        read.symptom = words("symptom");
        read.cause = words("cause");
        read.source = words("source");
        read.seen_on = json_.contains("seen_on") ? words("seen_on") : "";
        read.scene = scene();
        const json techniques = json_.value("techniques", usual);
        expect(is_list_of_strings(techniques) && !techniques.empty(), "techniques", "a list of techniques");
        for (const json &technique : techniques) {
            read.techniques.push_back(at("techniques", [&] { return parse_technique(technique.get<std::string>()); }));
        }
        if (json_.contains("textbook")) {
            const std::string textbook = words("textbook");
            read.textbook = at("textbook", [&] { return parse_technique(textbook); });
        }
        const json target = json_.value("textbook_target", json("float32"));
        expect(target == "float32" || target == "half", "textbook_target", "\"float32\" or \"half\"");
        read.textbook_target = target == "half" ? TextbookTarget::half : TextbookTarget::float32;
        const json bound = json_.value("bound", json(one_level));
        expect(bound.is_number() && bound.get<double>() > 0, "bound", "a number > 0");
        read.bound = bound.get<double>();
        const json unit = json_.value("unit", json(name_of(ErrorUnit::linear_color)));
        read.unit = unit == name_of(ErrorUnit::linear_color) ? ErrorUnit::linear_color : ErrorUnit::brightest_value;
        expect(unit == name_of(read.unit), "unit", "\"linear colour\" or \"brightest value\"");
        return read;
    }

  private:
    static bool is_list_of_strings(const json &value) {
        return value.is_array() && std::ranges::all_of(value, [](const json &element) { return element.is_string(); });
    }

    void expect(bool good, const std::string &key, const std::string &what) const {
        if (!good && !json_.contains(key)) {
            throw InputError("{}: {}: missing; expected {}", file_, key, what);
        }
        if (!good) {
            throw InputError("{}: {}: expected {}, got {}", file_, key, what, short_json(json_[key]));
        }
    }

    [[nodiscard]] std::string words(const char *key) const {
        const json value = json_.value(key, json());
        const std::string text = value.is_string() ? value.get<std::string>() : "";
        expect(!text.empty(), key, "a string that is not empty");
        return text;
    }

    /// Runs `work`; what it says is wrong is said with the file and the key.
    template <typename Work> auto at(std::string_view key, Work work) const -> decltype(work()) {
        try {
            return work();
        } catch (const InputError &error) {
            throw InputError("{}: {}: {}", file_, key, error.what());
        }
    }

    [[nodiscard]] Scene scene() const {
        const json value = json_.value("scene", json());
        expect(value.is_string() || value.is_object(), "scene", "a scene's name, a file or a scene object");
        const Scene base = value.is_object() ? parse_scene(value.dump(), file_ + ": scene", folder_)
                                             : at("scene", [&] { return named_scene(value); });
        const json settings = json_.value("set", json::array());
        expect(is_list_of_strings(settings), "set", "a list of strings PATH=VALUE");
        return settings.empty()
                   ? base
                   : with_settings(base, settings.get<std::vector<std::string>>(), file_ + ": set", folder_);
    }

    [[nodiscard]] Scene named_scene(const std::string &name) const {
        const std::string base = fmt::format("stability/scenes/{}.json", name);
        if (const auto text = assets_.read(base)) {
            return parse_scene(*text, base, assets_.folder());
        }
        const fs::path path(name);
        return open_scene(path.has_extension() ? (folder_ / path).string() : name, assets_);
    }

    std::string file_;
    fs::path folder_;
    const Assets &assets_;
    json json_;
};

/// Where each case stands in assets/stability/order.json.
std::map<std::string, std::size_t> order_of_cases(const Assets &assets) {
    std::map<std::string, std::size_t> order;
    for (const json &name :
         read_json<json>(assets.read("stability/order.json").value_or("[]"), "stability/order.json")) {
        order.emplace(name, order.size());
    }
    return order;
}

} // namespace

std::string_view name_of(ErrorUnit unit) {
    return unit == ErrorUnit::linear_color ? "linear colour" : "brightest value";
}

StabilityCase parse_stability_case(std::string_view text, const fs::path &file, const fs::path &folder,
                                   const Assets &assets) {
    return CaseReader(file.string(), folder, assets).read(text);
}

std::vector<StabilityCase> stability_cases(const Assets &assets) {
    const fs::path folder = assets.folder().empty() ? fs::path() : assets.folder() / cases_folder;
    std::vector<StabilityCase> cases;
    for (const std::string &path : assets.list(cases_folder)) {
        let_others_run();
        cases.push_back(parse_stability_case(assets.read(path).value_or(""), path, folder, assets));
    }
    const auto order = order_of_cases(assets);
    const auto rank = [&](const StabilityCase &ranked) {
        const auto found = order.find(ranked.name);
        return found == order.end() ? order.size() : found->second;
    };
    std::map<std::string, std::size_t> groups; // the rank of the first case
    for (const StabilityCase &ranked : cases) {
        const auto group = groups.emplace(ranked.group, rank(ranked)).first;
        group->second = std::min(group->second, rank(ranked));
    }
    std::ranges::stable_sort(cases, {}, [&](const StabilityCase &ranked) {
        return std::tuple(groups[ranked.group], ranked.group, rank(ranked));
    });
    return cases;
}

StabilityCase open_stability_case(const std::string &name_or_file, const Assets &assets) {
    const fs::path path(name_or_file);
    if (path.has_parent_path() || path.extension() == ".json") {
        return parse_stability_case(read_file(path, largest_json), path, fs::absolute(path).parent_path(), assets);
    }
    std::vector<std::string_view> names;
    const std::vector<StabilityCase> cases = stability_cases(assets);
    for (const StabilityCase &known : cases) {
        if (known.name == name_or_file) {
            return known;
        }
        names.push_back(known.name);
    }
    const std::string_view nearest = nearest_word(name_or_file, names);
    throw InputError("there is no case '{}'; {}", name_or_file,
                     nearest.empty() ? "`list` names them all" : fmt::format("did you mean '{}'?", nearest));
}

} // namespace sandbox

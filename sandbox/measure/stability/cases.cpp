#include "measure/stability/cases.h"

#include "image/error.h"
#include "image/image_file.h"
#include "scene/scene_file.h"
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
constexpr std::array<std::string_view, 10> known_keys{"group", "symptom",    "cause",    "source", "scene",
                                                      "set",   "techniques", "textbook", "bound",  "unit"};
constexpr std::array<ErrorUnit, 2> units{ErrorUnit::linear_color, ErrorUnit::brightest_value};

/// Runs `work`; what it says is wrong is said with `where` before it.
template <typename Work> auto at(const std::string &where, Work work) {
    try {
        return work();
    } catch (const InputError &error) {
        throw InputError(where + ": " + error.what());
    }
}

class CaseReader {
  public:
    CaseReader(std::string_view text, std::string file, fs::path folder, const Assets &assets)
        : file_(std::move(file)), folder_(std::move(folder)), assets_(assets) {
        try {
            json_ = json::parse(text);
        } catch (const json::exception &error) {
            throw InputError(file_ + ": expected JSON: " + error.what());
        }
        if (!json_.is_object()) {
            throw InputError(file_ + ": expected an object, got " + json_.dump());
        }
        for (const auto &[key, value] : json_.items()) {
            if (std::ranges::find(known_keys, key) == known_keys.end()) {
                throw InputError(file_ + ": " + key + ": unknown key of a stability case" +
                                 suggestion(key, known_keys));
            }
        }
    }

    [[nodiscard]] StabilityCase read() const {
        StabilityCase read;
        read.group = words("group");
        read.symptom = words("symptom");
        read.cause = words("cause");
        read.source = words("source");
        read.scene = scene();
        const json usual{"per-pixel/blinn-phong", "per-pixel/phong", "per-pixel/blinn-phong:program=full",
                         "per-vertex/blinn-phong"}; // where most equations run
        const json listed = json_.value("techniques", usual);
        expect(listed.is_array() && !listed.empty(), "techniques", "a list of techniques");
        for (std::size_t i = 0; i < listed.size(); ++i) {
            read.techniques.push_back(technique(listed[i], fmt::format("techniques[{}]", i)));
        }
        if (json_.contains("textbook")) {
            read.textbook = technique(json_["textbook"], "textbook");
        }
        const json bound = json_.value("bound", json(one_level));
        expect(bound.is_number() && bound.get<double>() > 0, "bound", "a number > 0");
        read.bound = bound.get<double>();
        read.unit = unit();
        return read;
    }

  private:
    void expect(bool good, const std::string &key, const std::string &what) const {
        if (!good) {
            const auto found = json_.find(key);
            const std::string got = found == json_.end() ? "missing; expected " + what
                                                         : fmt::format("expected {}, got {}", what, found->dump());
            throw InputError(file_ + ": " + key + ": " + got);
        }
    }

    [[nodiscard]] std::string words(const char *key) const {
        const json value = json_.value(key, json());
        expect(value.is_string() && !value.get_ref<const std::string &>().empty(), key, "a string that is not empty");
        return value;
    }

    [[nodiscard]] Technique technique(const json &value, const std::string &path) const {
        return at(file_ + ": " + path, [&] {
            if (!value.is_string()) {
                throw InputError("expected a technique such as per-pixel/phong, got " + value.dump());
            }
            return parse_technique(value.get_ref<const std::string &>());
        });
    }

    [[nodiscard]] ErrorUnit unit() const {
        const json word = json_.value("unit", json(name_of(ErrorUnit::linear_color)));
        const auto found = std::ranges::find_if(units, [&](ErrorUnit unit) { return word == name_of(unit); });
        expect(found != units.end(), "unit", "\"linear colour\" or \"brightest value\"");
        return *found;
    }

    [[nodiscard]] Scene scene() const {
        const json value = json_.value("scene", json());
        expect(value.is_string() || value.is_object(), "scene", "a scene's name, a file or a scene object");
        const Scene base = value.is_object() ? parse_scene(value.dump(), file_ + ": scene", folder_)
                                             : at(file_ + ": scene", [&] { return named_scene(value); });
        const json listed = json_.value("set", json::array());
        expect(listed.is_array() && std::ranges::all_of(listed, [](const json &one) { return one.is_string(); }), "set",
               "a list of strings PATH=VALUE");
        return with_settings(base, listed.get<std::vector<std::string>>(), file_ + ": set", folder_);
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
    for (const json &name : json::parse(assets.read("stability/order.json").value_or("[]"))) {
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
    StabilityCase read = CaseReader(text, file.string(), folder, assets).read();
    read.name = file.stem().string();
    return read;
}

std::vector<StabilityCase> stability_cases(const Assets &assets) {
    const fs::path folder = assets.folder().empty() ? fs::path() : assets.folder() / cases_folder;
    std::vector<StabilityCase> cases;
    for (const std::string &path : assets.list(cases_folder)) {
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
        return parse_stability_case(read_file(path), path, fs::absolute(path).parent_path(), assets);
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
    throw InputError(
        fmt::format("there is no case '{}'; {}", name_or_file,
                    nearest.empty() ? "`list` names them all" : fmt::format("did you mean '{}'?", nearest)));
}

} // namespace sandbox

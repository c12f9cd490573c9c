#include "scene/scene_file.h"

#include "image/error.h"
#include "scene/scene_json.h"
#include "scene/suggest.h"

#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>
#include <variant>

namespace sandbox {
namespace {

using Step = std::variant<std::string, std::size_t>; ///< a key or an index

[[noreturn]] void refuse(std::string_view label, const std::string &what) {
    throw InputError(std::string(label) + ": " + what);
}

/// `lights[0].diffuse` as {"lights", 0, "diffuse"}.
std::vector<Step> parse_path(std::string_view path, std::string_view label) {
    std::vector<Step> steps;
    for (std::string_view rest = path; !rest.empty();) {
        if (rest.front() == '[') {
            std::size_t index = 0;
            const std::size_t end = rest.find(']');
            const char *stop = rest.data() + std::min(end, rest.size());
            const auto [parsed, error] = std::from_chars(rest.data() + 1, stop, index);
            if (end == std::string_view::npos || error != std::errc() || parsed != stop) {
                refuse(label, "expected an index such as [0]");
            }
            steps.emplace_back(index);
            rest.remove_prefix(end + 1);
            continue;
        }
        if (!steps.empty()) {
            if (rest.front() != '.') {
                refuse(label, "expected a path such as lights[0].diffuse");
            }
            rest.remove_prefix(1);
        }
        const std::string_view key = rest.substr(0, rest.find_first_of(".["));
        if (key.empty()) {
            refuse(label, "expected a path such as lights[0].diffuse");
        }
        steps.emplace_back(std::string(key));
        rest.remove_prefix(key.size());
    }
    return steps;
}

/// JSON, or a bare word as a string.
Json parse_value(std::string_view text, std::string_view label) {
    try {
        return parse_json(text, label);
    } catch (const InputError &) {
        if (text.starts_with('[') || text.starts_with('{') || text.starts_with('"')) {
            throw;
        }
        return std::string(text);
    }
}

Json &element(Json &json, std::size_t index, std::string_view label) {
    if (!json.is_array()) {
        refuse(label, "[" + std::to_string(index) + "] needs an array, and this is none");
    }
    if (index >= json.size()) {
        refuse(label, "index " + std::to_string(index) + " is out of range; there are " + std::to_string(json.size()));
    }
    return json[index];
}

/// A key that is not there yet (a checker's) is made; the reader refuses what the format does not know.
Json &member(Json &json, const std::string &key, std::string_view label, bool an_index_follows) {
    if (!json.is_object() && !json.is_null()) {
        refuse(label, "\"" + key + "\" needs an object, and this is none");
    }
    if (an_index_follows && !json.contains(key)) {
        std::vector<std::string_view> known;
        for (const auto &[name, value] : json.items()) {
            known.push_back(json.find(name).key());
        }
        refuse(label, "unknown key \"" + key + "\"" + suggestion(key, known));
    }
    return json[key];
}

/// `label` names the setting in messages; a texture or model is looked for in `folder`.
void set(Json &scene, std::string_view path, Json value, std::string_view label, const std::filesystem::path &folder) {
    const std::vector<Step> steps = parse_path(path, label);
    if (steps.empty()) {
        refuse(label, "expected a path such as lights[0].diffuse");
    }
    Json *parent = nullptr;
    Json *at = &scene;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        parent = at;
        const bool an_index_follows = i + 1 < steps.size() && std::holds_alternative<std::size_t>(steps[i + 1]);
        const auto *index = std::get_if<std::size_t>(&steps[i]);
        at = index != nullptr ? &element(*at, *index, label)
                              : &member(*at, std::get<std::string>(steps[i]), label, an_index_follows);
    }
    const auto *key = std::get_if<std::string>(&steps.back());
    const bool is_path = key != nullptr && (*key == "texture" || *key == "obj") && value.is_string();
    if (is_path) {
        value = resolve_path(value.get<std::string>(), folder);
    }
    if (key != nullptr && (*key == "shape" || *key == "obj")) { // another shape has other keys
        *parent = Json::object({{*key, std::move(value)}});
    } else {
        *at = std::move(value);
    }
}

} // namespace

Scene with_settings(const Scene &scene, std::span<const std::string> settings, std::string_view name,
                    const std::filesystem::path &folder) {
    Json json = write_scene(scene, Keys::all);
    for (const std::string &setting : settings) {
        const std::size_t equals = setting.find('=');
        const std::string path = setting.substr(0, equals);
        const std::string label = std::string(name) + " " + path;
        if (equals == std::string::npos) {
            refuse(label, "expected PATH=VALUE, such as lights[0].diffuse=0.5");
        }
        set(json, path, parse_value(std::string_view(setting).substr(equals + 1), label), label, folder);
    }
    return read_scene(json, name, {});
}

Scene with_setting(const Scene &scene, std::string_view path_equals_value) {
    const std::string setting(path_equals_value);
    return with_settings(scene, {&setting, 1}, "--set", std::filesystem::current_path());
}

} // namespace sandbox

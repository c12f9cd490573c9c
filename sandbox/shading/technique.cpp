#include "shading/technique.h"

#include "image/error.h"
#include "image/number.h"
#include "scene/scene.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace sandbox {
namespace {

static_assert(all_models.size() + 1 == std::size(model_values), "all but own");

std::string names_of(const auto &rows, std::string_view separator) {
    std::string text;
    for (const auto &row : rows) {
        text += fmt::format("{}{}", text.empty() ? "" : separator, row.name);
    }
    return text;
}

int parse_value(const TechniqueKey &key, std::string_view word, std::string_view technique) {
    const auto found = std::ranges::find(key.values, word, &TechniqueValue::name);
    if (found == key.values.end()) {
        throw InputError("technique '{}': {}: expected {}, got '{}'", technique, key.name, names_of(key.values, "|"),
                         word);
    }
    return static_cast<int>(found - key.values.begin());
}

double parse_tolerance(std::string_view word, std::string_view technique) {
    double value = 0;
    const auto [end, error] = read_number(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size() || !(value > 0 && value <= 1)) {
        throw InputError("technique '{}': {}: expected a number above 0 and at most 1, got '{}'", technique,
                         tolerance_name, word);
    }
    return value;
}

void parse_setting(Technique &result, std::string_view setting, std::string_view technique) {
    const auto equals = setting.find('=');
    if (equals != std::string_view::npos && setting.substr(0, equals) == tolerance_name) {
        result.tolerance = parse_tolerance(setting.substr(equals + 1), technique);
        return;
    }
    const auto *key = std::ranges::find(technique_settings, setting.substr(0, equals), &TechniqueKey::name);
    if (equals == std::string_view::npos || key == std::end(technique_settings)) {
        throw InputError("technique '{}': expected key=value with key one of {}, {}, got '{}'", technique,
                         names_of(technique_settings, ", "), tolerance_name, setting);
    }
    key->set(result, parse_value(*key, setting.substr(equals + 1), technique));
}

/// Why the value that `key` holds is refused; empty: it is not.
std::string_view refusal(const TechniqueKey &key, const Technique &technique) {
    if (technique.model == Model::own && key.kind != TechniqueKey::Kind::choice && key.get(technique) != 0) {
        return "has no meaning beside the model own, whose text decides";
    }
    const auto rule = key.value(technique).why_refused;
    return rule == nullptr ? std::string_view{} : rule(technique);
}

} // namespace

std::span<const TechniqueKey> technique_keys() {
    static constexpr auto all = [] {
        std::array<TechniqueKey, 2 + std::size(technique_settings)> keys{frequency_key, model_key};
        std::ranges::copy(technique_settings, keys.begin() + 2);
        return keys;
    }();
    return all;
}

std::optional<std::string> why_refused(const Technique &technique) {
    for (const TechniqueKey &key : technique_keys()) {
        if (const auto reason = refusal(key, technique); !reason.empty()) {
            return fmt::format("{}={} {}", key.name, key.value(technique).name, reason);
        }
    }
    if (technique.frequency != Frequency::automatic && technique.tolerance != default_tolerance) {
        return fmt::format("{}={} can have no effect: it is for the frequency auto", tolerance_name,
                           technique.tolerance);
    }
    return std::nullopt;
}

Technique parse_technique(std::string_view text) { return parse_technique_with({}, text); }

Technique parse_technique_with(const OwnShader &own, std::string_view text) {
    Technique result;
    const auto slash = text.find('/');
    if (slash == std::string_view::npos) {
        throw InputError("technique '{}': expected FREQUENCY/MODEL[:key=value,...], e.g. "
                         "per-pixel/blinn-phong; FREQUENCY {}, MODEL {}",
                         text, names_of(frequency_values, "|"), names_of(model_values, "|"));
    }
    const auto colon = text.find(':', slash);
    frequency_key.set(result, parse_value(frequency_key, text.substr(0, slash), text));
    model_key.set(result, parse_value(model_key, text.substr(slash + 1, colon - slash - 1), text));
    result.own = result.model == Model::own ? own : OwnShader();
    for (auto end = colon; end != std::string_view::npos;) {
        const auto start = end + 1;
        end = text.find(',', start);
        parse_setting(result, text.substr(start, end - start), text);
    }
    if (const auto reason = why_refused(result)) {
        throw InputError("technique '{}' is refused: {}", text, *reason);
    }
    return result;
}

std::string to_string(const Technique &technique) {
    std::string text = fmt::format("{}/{}", frequency_key.value(technique).name, model_key.value(technique).name);
    char separator = ':';
    if (technique.tolerance != default_tolerance) {
        text += fmt::format(":{}={}", tolerance_name, technique.tolerance);
        separator = ',';
    }
    for (const TechniqueKey &key : technique_settings) {
        if (key.get(technique) != 0) {
            text += fmt::format("{}{}={}", separator, key.name, key.value(technique).name);
            separator = ',';
        }
    }
    return text;
}

std::string title_of(const TechniqueKey &key, int value) {
    const std::string_view title = key.values[static_cast<std::size_t>(value)].title;
    if (key.kind == TechniqueKey::Kind::choice) {
        return std::string(title);
    }
    return fmt::format("{}: {}{}", key.title, title, key.is_fault() && value != 0 ? " (wrong)" : "");
}

std::string title_of(const Technique &technique) {
    std::string text = fmt::format("{}, {}", frequency_key.value(technique).title, model_key.value(technique).title);
    if (technique.tolerance != default_tolerance) {
        text += fmt::format("; {} {:.3g}", tolerance_name, technique.tolerance);
    }
    for (const TechniqueKey &key : technique_settings) {
        if (key.get(technique) != 0) {
            text += "; " + title_of(key, key.get(technique));
        }
    }
    return text;
}

Technique nearest_valid(Technique technique) {
    for (const TechniqueKey &key : technique_keys()) {
        if (!refusal(key, technique).empty()) {
            key.set(technique, 0);
        }
    }
    technique.tolerance = technique.frequency == Frequency::automatic ? technique.tolerance : default_tolerance;
    return technique;
}

Technique part_of_auto(const Technique &technique, Frequency frequency) {
    if (technique.frequency != Frequency::automatic) {
        return technique;
    }
    Technique part = technique;
    part.frequency = frequency;
    return nearest_valid(part);
}

bool can_matter(const TechniqueKey &key, int value, const Scene &scene, const Technique &technique) {
    const auto rule = key.values[static_cast<std::size_t>(value)].can_matter;
    return rule == nullptr ||
           std::ranges::any_of(scene.objects, [&](const Object &object) { return rule(scene, object, technique); });
}

std::vector<TechniqueKey> settings_without_effect(const Scene &scene, const Technique &technique) {
    std::vector<TechniqueKey> idle;
    for (const TechniqueKey &key : technique_settings) {
        const int value = key.get(technique);
        if (value != 0 && !can_matter(key, value, scene, technique)) {
            idle.push_back(key);
        }
    }
    return idle;
}

} // namespace sandbox

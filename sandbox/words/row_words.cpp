#include "words/row_words.h"

#include <type_traits>

namespace sandbox {

namespace {

std::string value_key(const TechniqueKey &key, int value) {
    return fmt::format("technique.{}.{}", key.name, key.values[static_cast<std::size_t>(value)].name);
}
std::string overlay_key(const OverlayKind &kind) { return fmt::format("overlay.{}", kind.word); }
std::string unit_key(std::string_view unit) { return fmt::format("unit.{}", unit); }
std::string word_key(std::string_view word) { return fmt::format("word.{}", word); }
std::string light_key(const LightKind &kind) { return fmt::format("light_kind.{}", kind.word); }
std::string title_key(const TechniqueKey &key) { return fmt::format("technique.{}", key.name); }

/// Of all rows of T that have a control, and of what these hold.
template <class T> void collect(std::map<std::string, std::string> &texts) {
    for_each_field<T>([&](const auto &field) {
        using Member = std::remove_cvref_t<decltype(T{}.*field.member)>;
        if (!field.has_control) {
            return;
        }
        texts.emplace(row_key(field), field.rules.label);
        if constexpr (HasFormat<Member>) {
            collect<Member>(texts);
            return; // a heading, which has no hint
        } else if constexpr (HasWords<Member>) {
            for (const std::string_view word : words_of<Member>) {
                texts.emplace(word_key(word), word);
            }
        }
        texts.emplace(row_key(field) + ".help", field.doc);
        if (!field.range.unit.empty()) {
            texts.emplace(unit_key(field.range.unit), field.range.unit);
        }
    });
}

} // namespace

std::string row_text(const Words &words, const std::string &key, std::string_view own) {
    const std::string *text = words.find(key);
    return text != nullptr ? *text : std::string(own);
}

std::string unit_of(const Words &words, const Range &range) {
    return row_text(words, unit_key(range.unit), range.unit);
}
std::string word_of(const Words &words, std::string_view word) { return row_text(words, word_key(word), word); }
std::string title_of(const Words &words, const LightKind &kind) { return row_text(words, light_key(kind), kind.word); }
std::string title_of(const Words &words, const OverlayKind &kind) {
    return row_text(words, overlay_key(kind), kind.title);
}
std::string help_of(const Words &words, const OverlayKind &kind) {
    return row_text(words, overlay_key(kind) + ".help", kind.help);
}

std::string title_of(const Words &words, const TechniqueKey &key) { return row_text(words, title_key(key), key.title); }

std::string title_of(const Words &words, const TechniqueKey &key, int value) {
    const std::string title = row_text(words, value_key(key, value), key.values[static_cast<std::size_t>(value)].title);
    if (key.kind == TechniqueKey::Kind::choice) {
        return title;
    }
    return words.format(key.is_fault() && value != 0 ? "technique.fault" : "technique.setting", title_of(words, key),
                        title);
}

std::string title_of(const Words &words, const Technique &technique) {
    std::string text = words.format("technique.pair", title_of(words, frequency_key, frequency_key.get(technique)),
                                    title_of(words, model_key, model_key.get(technique)));
    if (technique.tolerance != default_tolerance) {
        text += words.text("technique.and") +
                words.format("technique.tolerance", fmt::format("{:.3g}", technique.tolerance));
    }
    for (const TechniqueKey &key : technique_settings) {
        if (key.get(technique) != 0) {
            text += words.text("technique.and") + title_of(words, key, key.get(technique));
        }
    }
    return text;
}

std::string name_of(const Words &words, const TechniqueKey &key, int value) {
    return row_text(words, value_key(key, value), key.values[static_cast<std::size_t>(value)].name);
}

std::string look_for(const Words &words, const TechniqueKey &key, int value) {
    return row_text(words, value_key(key, value) + ".look_for", key.values[static_cast<std::size_t>(value)].look_for);
}

std::string file_text(const Words &words, const std::string &own) { return row_text(words, file_text_key(own), own); }
std::string file_text_key(const std::string &own) { return fmt::format("text.{}", own); }

std::vector<std::string> texts_of(const Scene &scene) {
    std::vector<std::string> texts{scene.name, scene.description};
    for (const Object &object : scene.objects) {
        texts.push_back(object.name);
    }
    for (const View &view : scene.views) {
        texts.push_back(view.name);
    }
    return texts;
}

std::map<std::string, std::string> row_texts() {
    std::map<std::string, std::string> texts;
    collect<Scene>(texts);
    collect<Light>(texts);
    collect<Camera>(texts);
    collect<Object>(texts);
    collect<Transform>(texts);
    collect<Material>(texts);
    collect<Checker>(texts);
    for_each_shape([&]<class S>(std::type_identity<S>) {
        collect<S>(texts);
        texts.emplace(word_key(format_of<S>.name), format_of<S>.name);
    });
    for (const std::string_view word : words_of<Projection>) {
        texts.emplace(word_key(word), word); // whose control its panel makes by itself
    }
    for (const LightKind &kind : light_kinds) {
        texts.emplace(light_key(kind), kind.word);
    }
    for (const OverlayKind &kind : overlay_kinds) {
        texts.emplace(overlay_key(kind), kind.title);
        texts.emplace(overlay_key(kind) + ".help", kind.help);
    }
    for (const TechniqueKey &key : technique_keys()) {
        texts.emplace(title_key(key), key.title);
        for (int value = 0; value < static_cast<int>(key.values.size()); ++value) {
            texts.emplace(value_key(key, value), key.values[static_cast<std::size_t>(value)].title);
            texts.emplace(value_key(key, value) + ".look_for", key.values[static_cast<std::size_t>(value)].look_for);
        }
    }
    return texts;
}

} // namespace sandbox

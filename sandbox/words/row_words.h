#pragma once

#include "scene/light_kind.h"
#include "scene/overlays.h"
#include "scene/scene_format.h"
#include "shading/technique.h"
#include "words/words.h"

#include <fmt/format.h>
#include <map>
#include <string>
#include <string_view>
#include <vector>

/// The texts of the tables' rows (scene properties, technique values, ...). In English they stand in the rows, which
/// --help, schemas and messages read as well; other languages have them under keys made from the rows' own words.
namespace sandbox {

/// The text of `key` in a language other than English, else the row's own.
std::string row_text(const Words &words, const std::string &key, std::string_view own);

template <class T, class M> std::string row_key(const Field<T, M> &field) {
    return fmt::format("scene.{}.{}", format_of<T>.name, field.key);
}
/// What a control's row is called, without the unit, and what it is for.
template <class T, class M> std::string label_of(const Words &words, const Field<T, M> &field) {
    return row_text(words, row_key(field), field.rules.label);
}
template <class T, class M> std::string help_of(const Words &words, const Field<T, M> &field) {
    return row_text(words, row_key(field) + ".help", field.doc);
}
/// "degrees"
std::string unit_of(const Words &words, const Range &range);
/// A word of scene files: "orthographic".
std::string word_of(const Words &words, std::string_view word);
std::string title_of(const Words &words, const LightKind &kind);
std::string title_of(const Words &words, const OverlayKind &kind);
std::string help_of(const Words &words, const OverlayKind &kind);

/// As title_of() in shading/technique.h.
std::string title_of(const Words &words, const TechniqueKey &key);
std::string title_of(const Words &words, const TechniqueKey &key, int value);
std::string title_of(const Words &words, const Technique &technique);
/// As commands write a value, or its title in another language: "per-vertex".
std::string name_of(const Words &words, const TechniqueKey &key, int value);
std::string look_for(const Words &words, const TechniqueKey &key, int value);

/// A text that a scene or a stability case brings along: its name, what it calls an object, what it tells. Many of them
/// say the same, so other languages have it under a key made from the text itself; one that they lack stays as it is.
std::string file_text(const Words &words, const std::string &own);
std::string file_text_key(const std::string &own);

/// Every such key with its English text.
std::map<std::string, std::string> row_texts();
/// Those that a scene brings along.
std::vector<std::string> texts_of(const Scene &scene);

} // namespace sandbox

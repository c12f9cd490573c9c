#pragma once

#include "ui/session/usable_controls.h"
#include "ui/widgets/widgets.h"
#include "words/row_words.h"

#include <fmt/format.h>
#include <string>
#include <type_traits>
#include <vector>

namespace sandbox {

/// With its unit.
template <class T, class M> Label label_of(const Session &session, const Field<T, M> &field) {
    const auto in = [&](const Words &words) {
        const std::string label = label_of(words, field);
        return field.range.unit.empty() ? label : words.format("row.unit", label, unit_of(words, field.range));
    };
    return {in(session.words), in(session.words.english())};
}

/// Of an enumeration of scene files.
template <class E> std::vector<Label> word_labels(const Session &session) {
    std::vector<Label> labels;
    for (const std::string_view word : words_of<E>) {
        labels.emplace_back(word_of(session.words, word), std::string(word));
    }
    return labels;
}

/// The controls of a part of the scene, made from its rows in scene_format.h: one for every property that can change
/// the picture. A property that holds others (attenuation) becomes a heading with theirs. A right click resets to
/// `opened`.
template <class T> void property_rows(Session &session, T &value, const T &opened) {
    const Document &document = session.document;
    const Terms terms = terms_of(document.scene, document.left, document.right);
    for_each_field<T>([&](const auto &field) {
        using Member = std::remove_cvref_t<decltype(value.*field.member)>;
        if (!field.has_control || !is_usable(field, value, terms)) {
            return;
        }
        if constexpr (HasFormat<Member>) {
            heading(label_of(session.words, field));
            property_rows(session, value.*field.member, opened.*field.member);
        } else if constexpr (HasWords<Member>) {
            auto chosen = static_cast<std::size_t>(value.*field.member);
            if (choice_row(session, label_of(session, field), word_labels<Member>(session), chosen,
                           help_of(session.words, field))) {
                value.*field.member = static_cast<Member>(chosen);
            }
        } else if constexpr (requires(Row row, Member & member) { control_row(session, row, member, member); }) {
            const Row row{label_of(session, field), field.range, help_of(session.words, field)};
            control_row(session, row, value.*field.member, opened.*field.member);
        }
    });
}

} // namespace sandbox

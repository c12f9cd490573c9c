#pragma once

#include "ui/session/usable_controls.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>
#include <string>
#include <type_traits>
#include <vector>

namespace sandbox {

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
            heading(field.rules.label);
            property_rows(session, value.*field.member, opened.*field.member);
        } else if constexpr (HasWords<Member>) {
            const std::vector<std::string> names(words_of<Member>.begin(), words_of<Member>.end());
            auto chosen = static_cast<std::size_t>(value.*field.member);
            if (choice_row(session, std::string(field.rules.label).c_str(), names, chosen,
                           std::string(field.doc).c_str())) {
                value.*field.member = static_cast<Member>(chosen);
            }
        } else if constexpr (requires(Row row, Member & member) { control_row(session, row, member, member); }) {
            const std::string_view comma = field.range.unit.empty() ? "" : ", ";
            const Row row{fmt::format("{}{}{}", field.rules.label, comma, field.range.unit), field.range,
                          std::string(field.doc)};
            control_row(session, row, value.*field.member, opened.*field.member);
        }
    });
}

} // namespace sandbox

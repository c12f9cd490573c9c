#pragma once

#include <string>
#include <utility>

namespace sandbox {

/// What a widget shows, and what scripts call it: its English text, whatever the language.
struct Label {
    std::string shown, name;

    /// The same in every language: a name from a file, a number.
    Label(std::string same) : shown(same), name(std::move(same)) {}
    Label(const char *same) : Label(std::string(same)) {}
    Label(std::string shown_text, std::string english) : shown(std::move(shown_text)), name(std::move(english)) {}
    /// As Dear ImGui takes it: what it knows an item by does not change with the language.
    [[nodiscard]] std::string id() const { return shown + "###" + name; }
};

} // namespace sandbox

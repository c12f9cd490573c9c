#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// Text that strangers wrote, made harmless to a terminal and a page.
namespace sandbox {

/// A UTF-8 character.
struct Character {
    std::size_t length = 0; ///< bytes; 0: it is none
    char32_t code = 0;
};
/// What `text`, which is not empty, begins with.
Character first_character(std::string_view text);

/// Controls, and marks that are not seen or turn what is.
bool is_hidden(char32_t code);

bool is_utf8(std::string_view text);

/// On one line: control characters, marks that turn the direction of text and bytes that are no UTF-8 become \xNN.
std::string plain_text(std::string_view text);
/// The same, but line ends and tabs stay.
std::string plain_lines(std::string_view text);

} // namespace sandbox

#include "teach/marking/answer_names.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <fmt/format.h>
#include <set>

namespace sandbox {
namespace {

/// The length of the UTF-8 character that `text` begins with, and its code; length 0: it begins with none.
struct Character {
    std::size_t length = 0;
    char32_t code = 0;
};
Character first_character(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byte(0);
    const std::size_t length = first < 0x80   ? 1
                               : first < 0xC2 ? 0
                               : first < 0xE0 ? 2
                               : first < 0xF0 ? 3
                               : first < 0xF5 ? 4
                                              : 0;
    if (length == 0 || text.size() < length) {
        return {};
    }
    char32_t code = length == 1 ? first : first & (0xFFU >> (length + 1));
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0U) != 0x80) {
            return {};
        }
        code = code << 6 | (byte(i) & 0x3FU);
    }
    constexpr std::array<char32_t, 5> least{0, 0, 0x80, 0x800, 0x10000};
    const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
    return code < least[length] || code > 0x10FFFF || surrogate ? Character{} : Character{length, code};
}

/// Controls, and marks that are not seen or turn what is.
bool is_hidden(char32_t code) {
    return code < 0x20 || (code >= 0x7F && code < 0xA0) || code == 0xAD || (code >= 0x200B && code <= 0x200F) ||
           (code >= 0x2028 && code <= 0x202E) || (code >= 0x2060 && code <= 0x206F) || code == 0xFEFF ||
           (code >= 0xE000 && code <= 0xF8FF) || (code >= 0xFFF0 && code <= 0xFFFF) || code >= 0xE0000;
}

constexpr std::size_t longest_page = 80; ///< bytes: file systems take 255, with what is added

std::string lower(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

/// Letters, digits, -, _ and single dots of ASCII, and what is seen of other scripts.
std::string safe(std::string_view name) {
    std::string out;
    while (!name.empty()) {
        const Character character = first_character(name);
        const std::size_t length = std::max<std::size_t>(character.length, 1);
        const auto c = static_cast<unsigned char>(name.front());
        const bool plain = character.length == 1 && (std::isalnum(c) != 0 || c == '-' || c == '_' ||
                                                     (c == '.' && !out.empty() && out.back() != '.'));
        const bool other = character.length > 1 && !is_hidden(character.code);
        const std::string taken = plain || other ? std::string(name.substr(0, length)) : "_";
        if (out.size() + taken.size() > longest_page) {
            break;
        }
        out += taken;
        name.remove_prefix(length);
    }
    // "-" begins an option; devices of old systems, and this program's own pages, keep their names.
    static const std::set<std::string> taken{"con", "prn", "aux", "nul", "index"};
    const std::string low = lower(out.substr(0, out.find('.')));
    const bool port = low.size() == 4 && (low.starts_with("com") || low.starts_with("lpt"));
    return out.empty() || out.front() == '-' || taken.contains(low) || port ? "_" + out : out;
}

} // namespace

std::string plain_text(std::string_view text) {
    std::string out;
    while (!text.empty()) {
        const Character character = first_character(text);
        const std::size_t length = std::max<std::size_t>(character.length, 1);
        if (character.length > 0 && !is_hidden(character.code)) {
            out += text.substr(0, length);
        } else {
            for (const char c : text.substr(0, length)) {
                out += fmt::format("\\x{:02X}", static_cast<unsigned char>(c));
            }
        }
        text.remove_prefix(length);
    }
    return out;
}

std::string plain_cell(std::string_view text) {
    const bool formula = !text.empty() && std::string_view("=+-@\t\r\n").find(text.front()) != std::string_view::npos;
    return (formula ? "'" : "") + plain_text(text);
}

std::vector<std::string> page_names(const std::vector<std::string> &answers) {
    std::set<std::string> taken;
    std::vector<std::string> pages;
    for (const std::string &answer : answers) {
        const std::string name = safe(answer);
        std::string page = name;
        for (int i = 2; !taken.insert(lower(page)).second; ++i) {
            page = fmt::format("{}-{}", name, i);
        }
        pages.push_back(page + ".html");
    }
    return pages;
}

} // namespace sandbox

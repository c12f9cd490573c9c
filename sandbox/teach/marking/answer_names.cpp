#include "teach/marking/answer_names.h"

#include "image/plain_text.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <fmt/format.h>
#include <set>

namespace sandbox {
namespace {

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

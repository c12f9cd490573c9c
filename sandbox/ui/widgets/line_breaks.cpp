#include "ui/widgets/line_breaks.h"

#include "image/system_font.h"

#include <vector>

namespace sandbox {

namespace {

constexpr std::u32string_view closing = U"。，、；：？！）》」』】”’…,.;:?!%)]}";
constexpr std::u32string_view opening = U"（《「『【“‘([{";

struct Character {
    char32_t code = 0;
    std::string_view bytes;
    float advance = 0;
};

bool is_chinese(char32_t code) { return code >= first_chinese; }

bool may_break(char32_t before, char32_t after) {
    return (before == ' ' || is_chinese(before) || is_chinese(after)) && after != ' ' &&
           closing.find(after) == std::u32string_view::npos && opening.find(before) == std::u32string_view::npos;
}

std::vector<Character> characters_of(std::string_view text, const std::function<float(char32_t)> &advance) {
    std::vector<Character> all;
    while (!text.empty()) {
        const std::string_view rest = text;
        const char32_t code = take_character(text);
        all.push_back({code, rest.substr(0, rest.size() - text.size()), advance(code)});
    }
    return all;
}

} // namespace

bool has_chinese(std::string_view text) {
    while (!text.empty()) {
        if (is_chinese(take_character(text))) {
            return true;
        }
    }
    return false;
}

std::string in_lines(std::string_view text, float width, const std::function<float(char32_t)> &advance) {
    const std::vector<Character> all = characters_of(text, advance);
    std::string lines;
    std::size_t begin = 0; // of the line
    const auto end_line = [&](std::size_t end) {
        std::size_t last = end;
        for (; last > begin && all[last - 1].code == ' '; --last) {
        }
        for (; begin < last; ++begin) {
            lines += all[begin].bytes;
        }
        begin = end;
    };
    float used = 0;
    std::size_t may_end = 0; // the last place where the line may end
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all[i].code == '\n') {
            end_line(i);
            used = 0;
            continue;
        }
        if (i > begin && may_break(all[i - 1].code, all[i].code)) {
            may_end = i;
        }
        used += all[i].advance;
        while (used > width && i > begin && all[i].code != ' ') {
            end_line(may_end > begin ? may_end : i);
            lines += '\n';
            used = 0;
            for (std::size_t k = begin; k <= i; ++k) {
                used += all[k].advance;
            }
        }
    }
    end_line(all.size());
    return lines;
}

} // namespace sandbox

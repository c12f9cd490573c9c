#include "measure/report/paper.h"

#include "scene/assets.h"

#include <charconv>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>

namespace sandbox {
namespace {

/// The variables of the style's first block, which holds the light theme.
std::map<std::string, PaperColor, std::less<>> light_theme() {
    const std::string style = Assets("assets").read("page/style.css").value_or("");
    std::istringstream block(style.substr(0, style.find('}')));
    std::map<std::string, PaperColor, std::less<>> colors;
    for (std::string name, value; block >> name;) { // "--front: #1b1e24;"
        unsigned hex = 0;
        if (name.starts_with("--") && name.ends_with(':') && block >> value && value.starts_with('#') &&
            value.size() >= 7 && std::from_chars(value.data() + 1, value.data() + 7, hex, 16).ptr == value.data() + 7) {
            colors[name.substr(2, name.size() - 3)] = {static_cast<std::uint8_t>(hex >> 16U & 0xFFU),
                                                       static_cast<std::uint8_t>(hex >> 8U & 0xFFU),
                                                       static_cast<std::uint8_t>(hex & 0xFFU)};
        }
    }
    return colors;
}

} // namespace

PaperColor paper_color(std::string_view name) {
    static const auto colors = light_theme();
    const auto found = colors.find(name);
    if (found == colors.end()) {
        throw std::invalid_argument("paper_color: no colour " + std::string(name));
    }
    return found->second;
}

PaperColor series_paper_color(std::optional<int> style) {
    constexpr std::array<std::string_view, 10> names{"s0", "s1", "s2", "s3", "s4", "s5", "a", "b", "p3", "muted"};
    return paper_color(style ? names[static_cast<std::size_t>(*style) % names.size()] : "front");
}

} // namespace sandbox

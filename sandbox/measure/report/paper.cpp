#include "measure/report/paper.h"

#include "scene/assets.h"

#include <map>
#include <regex>
#include <stdexcept>
#include <string>

namespace sandbox {
namespace {

/// The variables of the style's first block, which holds the light theme.
std::map<std::string, PaperColor, std::less<>> light_theme() {
    const std::string style = Assets("assets").read("page/style.css").value_or("");
    const std::string block = style.substr(0, style.find('}'));
    static const std::regex variable("--([a-z0-9-]+): #([0-9a-f]{6})");
    std::map<std::string, PaperColor, std::less<>> colors;
    for (std::sregex_iterator at(block.begin(), block.end(), variable), end; at != end; ++at) {
        const auto hex = static_cast<unsigned>(std::stoul((*at)[2], nullptr, 16));
        colors[(*at)[1]] = {static_cast<std::uint8_t>(hex >> 16U & 0xFFU), static_cast<std::uint8_t>(hex >> 8U & 0xFFU),
                            static_cast<std::uint8_t>(hex & 0xFFU)};
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
    constexpr std::array<std::string_view, 9> names{"s0", "s1", "s2", "s3", "s4", "a", "b", "p3", "muted"};
    return paper_color(style ? names[static_cast<std::size_t>(*style) % names.size()] : "front");
}

} // namespace sandbox

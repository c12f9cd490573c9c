#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

/// The colours of plots that stand alone in a file, on white paper: those of a page's light theme, by their names in
/// assets/page/style.css.
namespace sandbox {

using PaperColor = std::array<std::uint8_t, 3>;
/// "ink", "muted", "rule", "s0", ... Throws std::invalid_argument for a name that the style does not have.
PaperColor paper_color(std::string_view name);

/// The styles of series that are no frequencies, behind those that are.
constexpr int style_a = 6, style_b = 7, style_truth = 8, style_guide = 9;
/// Of a series; none: of the front.
PaperColor series_paper_color(std::optional<int> style);

} // namespace sandbox

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

/// The styles of series that are no frequencies.
constexpr int style_a = 5, style_b = 6, style_truth = 7, style_guide = 8;
/// Of a series; none: of the front.
PaperColor series_paper_color(std::optional<int> style);

} // namespace sandbox

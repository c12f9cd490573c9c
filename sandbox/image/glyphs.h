#pragma once

#include <string_view>

namespace sandbox {

/// The strokes of an ASCII character: groups apart by spaces, each a run of points "xy" in base 36; '~' before a group:
/// its points are the control points of a curve. y: 0 foot of descenders, 4 baseline, e top of an x, i top of a
/// capital.
std::string_view glyph_strokes(char character);

/// The largest y that a glyph reaches.
constexpr double glyph_top = 20;

} // namespace sandbox

#pragma once

#include "image/image.h"

#include <array>
#include <string_view>

namespace sandbox {

/// Width in pixels of `text` in a line `height` pixels tall (from above a capital to the foot of a descender).
double text_width(std::string_view text, double height);

/// Writes `text` in the project's own stroke font, anti-aliased at any height, clipped to the picture.
/// (x, y): top left corner of the line, in pixels. ASCII, and what an installed Chinese font or a page's browser
/// has; anything else is drawn as '?'.
void draw_text(ByteImage &image, double x, double y, double height, std::string_view text,
               std::array<std::uint8_t, 3> color = {255, 255, 255});

} // namespace sandbox

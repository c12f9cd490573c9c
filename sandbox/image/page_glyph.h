#pragma once

#include "image/system_font.h"

namespace sandbox {

/// As the browser draws `character`, which it does in some way whatever it is; an em is `height` pixels; y
/// is from the baseline.
GlyphPicture page_glyph(char32_t character, double height);
double page_glyph_advance(char32_t character, double height);

} // namespace sandbox

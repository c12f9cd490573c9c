#pragma once

#include "capture/layout.h"

#include <string_view>

/// Labels drawn over a picture, never over a PFM, which is data.
namespace sandbox {

/// Draws a strip along the top that names the views: "A left" and "B right" over their halves; over a difference both,
/// in two lines, with `caption` at the right end; over a single view `left` alone. The text scales with the picture's
/// height, and shrinks or is cut to fit. `split`: the column where the right view begins.
void draw_labels(ByteImage &picture, Layout layout, int split, std::string_view left, std::string_view right,
                 std::string_view caption = {});

/// A thin upright line at column `split`, where a wipe changes from left to right.
void draw_divider(ByteImage &picture, int split);

} // namespace sandbox

#pragma once

#include "capture/layout.h"

#include <span>
#include <string>

/// Labels drawn over a picture, never over a PFM, which is data.
namespace sandbox {

/// Draws a strip along the top with a text over each view; over a difference the views' two, in two lines, with the
/// third at the right end. The text scales with the picture's height, and shrinks or is cut to fit. `splits`: the
/// columns where the second and third views begin.
void draw_labels(ByteImage &picture, Layout layout, std::span<const int> splits, std::span<const std::string> texts);

/// A thin upright line at column `split`, where one view ends and the next begins.
void draw_divider(ByteImage &picture, int split);

} // namespace sandbox

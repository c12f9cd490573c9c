#pragma once

#include "capture/layout.h"

#include <string_view>

/// What is drawn over a picture for its viewers; never in a PFM, which is data.
namespace sandbox {

/// A strip along the top that says what is seen: "A left" and "B right" over their halves, both in two lines over a
/// difference, which `caption` names at the right end, `left` alone over a single view. The text scales with the
/// picture's height, and shrinks or is cut to fit. `split`: the column where the right view begins.
void draw_labels(ByteImage &picture, Layout layout, int split, std::string_view left, std::string_view right,
                 std::string_view caption = {});

/// A thin upright line at column `split`, where a wipe changes from left to right.
void draw_divider(ByteImage &picture, int split);

} // namespace sandbox

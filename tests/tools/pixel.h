#pragma once

#include "image/cut_paste.h"

#include <array>

namespace sandbox {

using PixelRgb = std::array<int, 3>;

/// x to the right, y down from the upper left corner; of int, so that a failure prints numbers.
inline PixelRgb pixel(const ByteImage &image, int x, int y) {
    const ByteImage one = cut(image, x, y, {1, 1});
    return {one.rgb[0], one.rgb[1], one.rgb[2]};
}

} // namespace sandbox

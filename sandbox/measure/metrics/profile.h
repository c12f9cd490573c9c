#pragma once

#include "image/image.h"

#include <vector>

/// The profile: how bright a picture is along one of its rows.
namespace sandbox {

/// Of linear Rec. 709.
template <class Color> double luminance(const Color &c) {
    return 0.2126 * static_cast<double>(c.r) + 0.7152 * static_cast<double>(c.g) + 0.0722 * static_cast<double>(c.b);
}

/// One luminance a pixel, from left to right; empty: not known.
using Curve = std::vector<double>;
/// Along row `row`, 0 at the top; empty below the picture.
Curve luminance_row(const Image &image, int row);

} // namespace sandbox

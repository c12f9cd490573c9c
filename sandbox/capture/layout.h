#pragma once

#include "image/image.h"

#include <string_view>

/// How two views become one picture. Pure, on linear images.
namespace sandbox {

enum class Layout { single, side_by_side, wipe, difference };

/// "single", "side-by-side", "wipe", "difference".
std::string_view to_string(Layout layout);
/// Throws InputError listing the names.
Layout parse_layout(std::string_view text);

/// The size of each view of a picture. Side by side, each has half the width, and the left one has the extra column of
/// an odd width; in the other layouts each is as large as the picture.
struct ViewSizes {
    Size left, right;
};
/// Throws InputError if a view would have no pixel.
ViewSizes view_sizes(Layout layout, Size picture);

/// The first column of the right view, if the left one has `share` of the width: rounded, halves up.
int split_column(Size picture, double share = 0.5);

/// The picture in linear RGB; a difference is left - right (signed; alpha 1). Layout::single ignores `right`. The sizes
/// must be those of view_sizes(). `divider`: the left view's share of a wipe's width, [0, 1].
Image compose(Layout layout, const Image &left, const Image &right, double divider = 0.5);

} // namespace sandbox

#pragma once

#include "image/image.h"
#include "scene/overlays.h"

#include <span>
#include <string_view>
#include <vector>

/// How two views become one picture. Pure, on linear images.
namespace sandbox {

enum class Layout { single, side_by_side, wipe, difference, three_up };
/// The two pictures of a difference; the truth is the reference of the side's model.
enum class DifferenceOf { a_b, a_truth, b_truth };

/// "single", "side-by-side", "wipe", "difference", "three-up".
std::string_view to_string(Layout layout);
/// Throws InputError listing the names.
Layout parse_layout(std::string_view text);

/// How many views stand beside each other: A, B and, in a three-up, the truth.
int columns_of(Layout layout);
/// The size of each view of a picture. Beside each other, each has its part of the width, and the first ones have the
/// columns that are left over; in the other layouts each is as large as the picture.
std::vector<Size> view_sizes(Layout layout, Size picture);

/// Those that a view's picture itself holds. A difference is measured: it has the wireframe alone, the same on both
/// sides.
Overlays on_surfaces(Overlays overlays, Layout layout);

/// The first column of the right view, if the left one has `share` of the width: rounded, halves up.
int split_column(Size picture, double share = 0.5);

/// The picture in linear RGB; a difference is left - right (signed; alpha 1). There must be as many views, of the
/// sizes, as in view_sizes(). `divider`: the left view's share of a wipe's width, [0, 1].
Image compose(Layout layout, std::span<const Image> views, double divider = 0.5);

} // namespace sandbox

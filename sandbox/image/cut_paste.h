#pragma once

#include "image/image.h"

#include <array>
#include <cstdint>

namespace sandbox {

ByteImage black_picture(Size size);
/// The part of a picture whose upper left corner is (left, top); it must lie inside.
ByteImage cut(const ByteImage &picture, int left, int top, Size size);
/// Puts `part` over a picture, inside which it must lie.
void paste(ByteImage &onto, const ByteImage &part, int left, int top);
/// From (left, top) to (right, bottom), excluded, as far as it lies inside.
void fill_part(ByteImage &picture, int left, int top, int right, int bottom, std::array<std::uint8_t, 3> color);

} // namespace sandbox

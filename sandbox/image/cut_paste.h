#pragma once

#include "image/image.h"

namespace sandbox {

ByteImage black_picture(Size size);
/// The part of a picture whose upper left corner is (left, top); it must lie inside.
ByteImage cut(const ByteImage &picture, int left, int top, Size size);
/// Puts `part` over a picture, inside which it must lie.
void paste(ByteImage &onto, const ByteImage &part, int left, int top);

} // namespace sandbox

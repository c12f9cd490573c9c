#pragma once

#include "image/image.h"

#include <string_view>

namespace sandbox {

constexpr std::string_view jpeg_signature = "\xff\xd8\xff";

/// Upright, as the camera was held (EXIF); inks (CMYK, YCCK) as the light that they leave. Throws InputError for a
/// damaged file, for more than 8 bits a value, lossless or hierarchical compression, and for more than max_image_side
/// pixels a side. `name` is used in messages.
Image decode_jpeg(std::string_view bytes, std::string_view name);

} // namespace sandbox

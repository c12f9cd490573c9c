#pragma once

#include "image/image.h"

#include <string>
#include <string_view>

namespace sandbox {

constexpr std::string_view png_signature = "\x89PNG\r\n\x1a\n";

/// Throws InputError for a damaged file (a broken checksum of a chunk that no pixel needs is no damage), and for more
/// than max_image_side pixels a side. `name` is used in messages.
Image decode_png(std::string_view bytes, std::string_view name);
std::string encode_png(const ByteImage &image);

} // namespace sandbox

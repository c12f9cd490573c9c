#pragma once

#include "image/image.h"
#include "image/png_chunks.h" // png_signature

#include <string>
#include <string_view>

namespace sandbox {

/// All 16 bits of a file that has them. Throws InputError for a damaged file, and for more than max_image_side pixels a
/// side. A wrong checksum (a chunk's CRC-32, the Adler-32 of the pixel data) is damage where a pixel needs what it
/// covers, and nowhere else. `name` is used in messages.
Image decode_png(std::string_view bytes, std::string_view name);
std::string encode_png(const ByteImage &image);

} // namespace sandbox

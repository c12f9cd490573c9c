#pragma once

#include "image/image.h"

#include <string>
#include <string_view>

namespace sandbox {

/// Float32 RGB, little-endian, bottom row first, as PFM is.
std::string encode_pfm(const Image &image);
/// Colour or grey, of either byte order. Throws InputError. `name` is used in messages.
Image decode_pfm(std::string_view bytes, std::string_view name);

} // namespace sandbox

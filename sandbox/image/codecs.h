#pragma once

#include "image/image.h"

#include <string_view>

/// The decoders behind decode_image(): inside this room only.
namespace sandbox {

constexpr int max_image_side = 8192;
constexpr std::string_view png_signature = "\x89PNG\r\n\x1a\n";
constexpr std::string_view jpeg_signature = "\xff\xd8\xff";

Image decode_png(std::string_view bytes, std::string_view name);
Image decode_jpeg(std::string_view bytes, std::string_view name);

/// An image from interleaved 8-bit values (3 or 4 channels), each divided by 255.
Image from_bytes(Size size, const unsigned char *bytes, int channels);

} // namespace sandbox

#pragma once

#include "image/image.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace sandbox {

/// PNG (stb_image, PNG only) or JPEG (libjpeg-turbo), told apart by their first bytes; 8-bit values / 255, no sRGB
/// decoding. `name` is used in messages. Throws InputError. Refuses more than 8192 pixels a side.
Image decode_image(std::string_view bytes, std::string_view name);

std::string encode_png(const ByteImage &image);
/// Float32 RGB, little-endian, bottom row first, as PFM is.
std::string encode_pfm(const Image &image);
Image decode_pfm(std::string_view bytes, std::string_view name);

/// The whole file; throws InputError naming it.
std::string read_file(const std::filesystem::path &path);
/// Writes to a temporary name beside `path` and renames: whole or not at all. Throws InputError naming the path.
void write_file(const std::filesystem::path &path, std::string_view bytes);

} // namespace sandbox

#pragma once

#include "image/png.h"

#include <cstdint>
#include <string>
#include <utility>
#include <zlib.h>

/// PNG files of any form, byte by byte: what no ordinary program writes, too.
namespace sandbox {

inline std::string big_endian(std::uint32_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) {
        bytes += static_cast<char>(value >> shift & 0xFFU);
    }
    return bytes;
}

/// A chunk of a PNG file, its checksum right or broken.
inline std::string chunk(const std::string &type, const std::string &data, bool whole = true) {
    const std::string summed = type + data;
    const auto sum = static_cast<std::uint32_t>(
        crc32(0, reinterpret_cast<const Bytef *>(summed.data()), static_cast<uInt>(summed.size())));
    return big_endian(static_cast<std::uint32_t>(data.size())) + summed + big_endian(sum ^ (whole ? 0U : 1U));
}

/// A zlib stream; its last four bytes are the checksum.
inline std::string deflated(const std::string &bytes) {
    auto size = compressBound(static_cast<uLong>(bytes.size()));
    std::string out(size, '\0');
    compress(reinterpret_cast<Bytef *>(out.data()), &size, reinterpret_cast<const Bytef *>(bytes.data()),
             static_cast<uLong>(bytes.size()));
    out.resize(size);
    return out;
}

enum PngColor : char { png_grey = 0, png_rgb = 2, png_palette = 3, png_grey_alpha = 4, png_rgba = 6 };

inline std::string png_header(std::uint32_t width, std::uint32_t height, int depth, PngColor color,
                              bool interlaced = false) {
    return chunk("IHDR", big_endian(width) + big_endian(height) + static_cast<char>(depth) + static_cast<char>(color) +
                             std::string(2, '\0') + static_cast<char>(interlaced ? 1 : 0));
}
/// A whole file from its chunks.
inline std::string png_file(const std::string &chunks) {
    return std::string(png_signature) + chunks + chunk("IEND", "");
}
/// The same; `rows` is what is deflated: each row begins with its filter, 0 to 4.
inline std::string png_file(const std::string &header, const std::string &rows) {
    return png_file(header + chunk("IDAT", deflated(rows)));
}

} // namespace sandbox

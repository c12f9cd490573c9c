#include "image/image_size.h"

#include "image/jpeg.h"
#include "image/png.h"

#include <cstddef>
#include <limits>

namespace sandbox {
namespace {

/// `count` bytes, the highest first; 0 beyond the end.
std::size_t number_at(std::string_view bytes, std::size_t at, std::size_t count) {
    std::size_t value = 0;
    for (std::size_t i = at; i < at + count; ++i) {
        value = value << 8 | (i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0U);
    }
    return value;
}

std::optional<Size> checked(std::size_t width, std::size_t height) {
    constexpr std::size_t most = std::numeric_limits<int>::max();
    return width < 1 || height < 1 || width > most || height > most
               ? std::nullopt
               : std::optional(Size{static_cast<int>(width), static_cast<int>(height)});
}

/// IHDR comes first, but for Apple's CgBI.
std::optional<Size> png_size(std::string_view bytes) {
    for (std::size_t at = png_signature.size(); at + 16 <= bytes.size();) {
        const std::string_view type = bytes.substr(at + 4, 4);
        if (type == "IHDR") {
            return checked(number_at(bytes, at + 8, 4), number_at(bytes, at + 12, 4));
        }
        if (type != "CgBI") {
            break;
        }
        at += number_at(bytes, at, 4) + 12;
    }
    return std::nullopt;
}

/// The frame header (SOF0 to SOF15, but for the three of these codes that are something else).
std::optional<Size> jpeg_size(std::string_view bytes) {
    for (std::size_t at = 2; at + 9 <= bytes.size();) {
        const auto marker = static_cast<unsigned char>(bytes[at + 1]);
        if (bytes[at] != '\xff' || marker == 0xff) { // garbage or fill before a marker
            ++at;
        } else if (marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc) {
            return checked(number_at(bytes, at + 7, 2), number_at(bytes, at + 5, 2));
        } else if (marker == 0x01 || (marker >= 0xd0 && marker <= 0xd8)) { // without a length
            at += 2;
        } else {
            at += 2 + number_at(bytes, at + 2, 2);
        }
    }
    return std::nullopt;
}

} // namespace

std::optional<Size> image_size(std::string_view bytes) {
    return bytes.starts_with(png_signature)    ? png_size(bytes)
           : bytes.starts_with(jpeg_signature) ? jpeg_size(bytes)
                                               : std::nullopt;
}

} // namespace sandbox

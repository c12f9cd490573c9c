#include "image/exif.h"

#include <cstddef>
#include <cstdint>

namespace sandbox {
namespace {

constexpr std::string_view exif_header{"Exif\0\0", 6};
constexpr unsigned orientation_tag = 0x0112;
constexpr unsigned short_type = 3;

/// Numbers of a TIFF structure; 0 beyond its end.
struct Tiff {
    std::string_view bytes;
    bool big_endian;

    [[nodiscard]] std::size_t number(std::size_t at, std::size_t length) const {
        if (at > bytes.size() || bytes.size() - at < length) {
            return 0;
        }
        std::size_t value = 0;
        for (std::size_t i = 0; i < length; ++i) {
            value = value << 8 | static_cast<unsigned char>(bytes[at + (big_endian ? i : length - 1 - i)]);
        }
        return value;
    }
};

} // namespace

std::optional<Orientation> exif_orientation(std::string_view segment) {
    // Value of the tag - 1; which side of the picture the file's first row and first column are.
    static constexpr Orientation orientations[]{
        {false, false, false}, // top, left
        {false, true, false},  // top, right
        {false, true, true},   // bottom, right
        {false, false, true},  // bottom, left
        {true, false, false},  // left, top
        {true, false, true},   // right, top: a quarter turn clockwise makes it upright
        {true, true, true},    // right, bottom
        {true, true, false},   // left, bottom
    };
    if (!segment.starts_with(exif_header)) {
        return std::nullopt;
    }
    segment.remove_prefix(exif_header.size());
    const Tiff tiff{segment, segment.starts_with("MM")};
    const std::size_t directory = tiff.number(4, 4);
    const std::size_t entries = tiff.number(directory, 2);
    for (std::size_t i = 0; i < entries; ++i) {
        const std::size_t entry = directory + 2 + 12 * i;
        if (tiff.number(entry, 2) == orientation_tag && tiff.number(entry + 2, 2) == short_type) {
            const std::size_t value = tiff.number(entry + 8, 2);
            return value >= 1 && value <= 8 ? orientations[value - 1] : Orientation{};
        }
    }
    return Orientation{};
}

} // namespace sandbox

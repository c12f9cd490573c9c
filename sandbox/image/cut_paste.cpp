#include "image/cut_paste.h"

#include <algorithm>
#include <cstddef>

namespace sandbox {

namespace {

std::ptrdiff_t place(Size size, int x, int y) { return std::ptrdiff_t{3} * (std::ptrdiff_t{y} * size.width + x); }

} // namespace

ByteImage black_picture(Size size) {
    return {size, std::vector<std::uint8_t>(static_cast<std::size_t>(place(size, 0, size.height)))};
}

ByteImage cut(const ByteImage &picture, int left, int top, Size size) {
    ByteImage part = black_picture(size);
    for (int y = 0; y < size.height; ++y) {
        std::copy_n(picture.rgb.begin() + place(picture.size, left, top + y), place(size, size.width, 0),
                    part.rgb.begin() + place(size, 0, y));
    }
    return part;
}

void paste(ByteImage &onto, const ByteImage &part, int left, int top) {
    for (int y = 0; y < part.size.height; ++y) {
        std::copy_n(part.rgb.begin() + place(part.size, 0, y), place(part.size, part.size.width, 0),
                    onto.rgb.begin() + place(onto.size, left, top + y));
    }
}

void fill_part(ByteImage &picture, int left, int top, int right, int bottom, std::array<std::uint8_t, 3> color) {
    for (int y = std::max(0, top); y < std::min(bottom, picture.size.height); ++y) {
        for (int x = std::max(0, left); x < std::min(right, picture.size.width); ++x) {
            std::ranges::copy(color, picture.rgb.begin() + place(picture.size, x, y));
        }
    }
}

} // namespace sandbox

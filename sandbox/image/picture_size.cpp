#include "image/picture_size.h"

#include "image/error.h"

#include <charconv>

namespace sandbox {

namespace {

constexpr int longest_side = 16384;
constexpr long most_pixels = 64L << 20;

} // namespace

void check_size(Size size) {
    const auto side_ok = [](int side) { return side >= 1 && side <= longest_side; };
    if (!side_ok(size.width) || !side_ok(size.height) || static_cast<long>(size.width) * size.height > most_pixels) {
        throw InputError("expected WIDTHxHEIGHT with 1 to {} each and at most {} Mpixel in all, got {}x{}",
                         longest_side, most_pixels >> 20, size.width, size.height);
    }
}

Size parse_size(std::string_view text) {
    Size size;
    const char *const end = text.data() + text.size();
    const auto width = std::from_chars(text.data(), end, size.width);
    if (width.ec == std::errc() && width.ptr != end && *width.ptr == 'x') {
        const auto height = std::from_chars(width.ptr + 1, end, size.height);
        if (height.ec == std::errc() && height.ptr == end) {
            check_size(size);
            return size;
        }
    }
    throw InputError("expected WIDTHxHEIGHT such as 1280x720, got '{}'", text);
}

} // namespace sandbox

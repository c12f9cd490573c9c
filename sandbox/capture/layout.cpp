#include "capture/layout.h"

#include "image/error.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sandbox {
namespace {

constexpr std::array<std::string_view, 4> layout_names{"single", "side-by-side", "wipe", "difference"};

Image side_by_side(const Image &left, const Image &right) {
    Image picture({left.size.width + right.size.width, left.size.height});
    for (int y = 0; y < left.size.height; ++y) {
        std::copy_n(&left.at(0, y), left.size.width, &picture.at(0, y));
        std::copy_n(&right.at(0, y), right.size.width, &picture.at(left.size.width, y));
    }
    return picture;
}

Image wipe(const Image &left, const Image &right, double divider) {
    Image picture = left;
    const int split = split_column(left.size, divider);
    if (split == left.size.width) {
        return picture;
    }
    for (int y = 0; y < left.size.height; ++y) {
        std::copy_n(&right.at(split, y), left.size.width - split, &picture.at(split, y));
    }
    return picture;
}

Image difference(const Image &left, const Image &right) {
    Image picture(left.size);
    std::ranges::transform(
        left.pixels, right.pixels, picture.pixels.begin(),
        [](const glm::vec4 &a, const glm::vec4 &b) { return glm::vec4(a.r - b.r, a.g - b.g, a.b - b.b, 1); });
    return picture;
}

} // namespace

std::string_view to_string(Layout layout) { return layout_names[static_cast<std::size_t>(layout)]; }

Layout parse_layout(std::string_view text) {
    const auto found = std::ranges::find(layout_names, text);
    if (found == layout_names.end()) {
        throw InputError("expected side-by-side, wipe or difference, got '{}'", text);
    }
    return static_cast<Layout>(found - layout_names.begin());
}

int split_column(Size picture, double share) { return static_cast<int>(std::floor(picture.width * share + 0.5)); }

ViewSizes view_sizes(Layout layout, Size picture) {
    if (layout != Layout::side_by_side) {
        return {picture, picture};
    }
    if (picture.width < 2) {
        throw InputError("two views side by side need a width of at least 2, got {}", picture.width);
    }
    const int split = split_column(picture);
    return {{split, picture.height}, {picture.width - split, picture.height}};
}

Image compose(Layout layout, const Image &left, const Image &right, double divider) {
    switch (layout) {
    case Layout::single:
        break;
    case Layout::side_by_side:
        return side_by_side(left, right);
    case Layout::wipe:
        return wipe(left, right, divider);
    case Layout::difference:
        return difference(left, right);
    }
    return left;
}

} // namespace sandbox

#include "capture/layout.h"

#include "image/error.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sandbox {
namespace {

constexpr std::array<std::string_view, 5> layout_names{"single", "side-by-side", "wipe", "difference", "three-up"};

Image beside_each_other(std::span<const Image> views) {
    Size size{0, views.front().size.height};
    for (const Image &view : views) {
        size.width += view.size.width;
    }
    Image picture(size);
    int left = 0;
    for (const Image &view : views) {
        for (int y = 0; y < size.height; ++y) {
            std::copy_n(&view.at(0, y), view.size.width, &picture.at(left, y));
        }
        left += view.size.width;
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
        throw InputError("expected side-by-side, wipe, difference or three-up, got '{}'", text);
    }
    return static_cast<Layout>(found - layout_names.begin());
}

Overlays on_surfaces(Overlays overlays, Layout layout) {
    for (const OverlayKind &kind : overlay_kinds) {
        const bool shown = kind.in_difference || layout != Layout::difference;
        overlays.*kind.on = overlays.*kind.on && shown && kind.on != &Overlays::lights;
    }
    return overlays;
}

int split_column(Size picture, double share) { return static_cast<int>(std::floor(picture.width * share + 0.5)); }

int columns_of(Layout layout) { return layout == Layout::three_up ? 3 : layout == Layout::side_by_side ? 2 : 1; }

std::vector<Size> view_sizes(Layout layout, Size picture) {
    const int columns = columns_of(layout);
    if (columns == 1) {
        return std::vector<Size>(layout == Layout::single ? 1 : 2, picture);
    }
    if (picture.width < columns) {
        throw InputError("{} views beside each other need a width of at least {}, got {}", columns, columns,
                         picture.width);
    }
    std::vector<Size> sizes;
    for (int column = 0; column < columns; ++column) {
        sizes.push_back({picture.width / columns + (column < picture.width % columns ? 1 : 0), picture.height});
    }
    return sizes;
}

Image compose(Layout layout, std::span<const Image> views, double divider) {
    switch (layout) {
    case Layout::single:
        break;
    case Layout::side_by_side:
    case Layout::three_up:
        return beside_each_other(views);
    case Layout::wipe:
        return wipe(views[0], views[1], divider);
    case Layout::difference:
        return difference(views[0], views[1]);
    }
    return views[0];
}

} // namespace sandbox

#include "capture/labels.h"

#include "image/text.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>

namespace sandbox {
namespace {

constexpr double darkening = 0.35;   // of the display value, so that white text reads over anything
constexpr double smallest_text = 9;  // pixels a line; below that strokes run together
constexpr double line_spacing = 1.5; // line boxes

void darken(ByteImage &picture, int rows) {
    const std::size_t end = 3 * static_cast<std::size_t>(picture.size.width) *
                            static_cast<std::size_t>(std::min(rows, picture.size.height));
    for (std::uint8_t &value : std::span(picture.rgb).first(end)) {
        value = static_cast<std::uint8_t>(std::lround(value * darkening));
    }
}

/// `text` in a strip's line that begins at row `top`, within `width` columns from `left`: smaller or cut if it must be.
void draw_line(ByteImage &picture, std::string text, int left, int width, double top, double height) {
    const double margin = height / 2;
    const double room = width - 2 * margin;
    const double fitted = std::max(smallest_text, std::min(height, height * room / text_width(text, height)));
    if (text_width(text, fitted) > room) {
        while (!text.empty() && text_width(text + "...", fitted) > room) {
            text.pop_back();
        }
        text += text.empty() ? "" : "...";
    }
    draw_text(picture, left + margin, top + (height * line_spacing - fitted) / 2, fitted, text);
}

} // namespace

void draw_labels(ByteImage &picture, Layout layout, std::span<const int> splits, std::span<const std::string> texts) {
    const double height = std::max(smallest_text, picture.size.height / 26.0);
    const double strip = height * line_spacing;
    const int width = picture.size.width;
    if (layout == Layout::difference) {
        const int caption_width = std::min(width / 3, static_cast<int>(text_width(texts[2], height) + height + 1));
        darken(picture, static_cast<int>(2 * strip));
        draw_line(picture, texts[0], 0, width - caption_width, 0, height);
        draw_line(picture, texts[1], 0, width - caption_width, strip, height);
        draw_line(picture, texts[2], width - caption_width, caption_width, 0, height);
        return;
    }
    darken(picture, static_cast<int>(strip));
    for (std::size_t i = 0; i < texts.size(); ++i) {
        const int left = i == 0 ? 0 : splits[i - 1];
        const int right = i < splits.size() ? splits[i] : width;
        draw_line(picture, texts[i], left, right - left, 0, height);
    }
}

void draw_divider(ByteImage &picture, int split) {
    const int thickness = std::max(1, picture.size.height / 360);
    const int from = std::max(0, split - (thickness + 1) / 2);
    const int to = std::min(picture.size.width, from + thickness);
    for (int y = 0; y < picture.size.height; ++y) {
        const auto row = picture.rgb.begin() + std::ptrdiff_t{3} * y * picture.size.width;
        std::fill(row + std::ptrdiff_t{3} * from, row + std::ptrdiff_t{3} * to, static_cast<std::uint8_t>(255));
    }
}

} // namespace sandbox

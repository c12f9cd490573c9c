#include "capture/labels.h"

#include "image/text.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace sandbox {
namespace {

constexpr double darkening = 0.35;   // of the display value, so that white text reads over anything
constexpr double smallest_text = 9;  // pixels a line; below that strokes run together
constexpr double line_spacing = 1.5; // line boxes

/// The line height before it is made to fit: a 26th of the picture's.
double line_height(const ByteImage &picture) { return std::max(smallest_text, picture.size.height / 26.0); }

void darken(ByteImage &picture, int rows) {
    const std::size_t end = 3 * static_cast<std::size_t>(picture.size.width) *
                            static_cast<std::size_t>(std::min(rows, picture.size.height));
    std::transform(picture.rgb.begin(), picture.rgb.begin() + static_cast<std::ptrdiff_t>(end), picture.rgb.begin(),
                   [](std::uint8_t v) { return static_cast<std::uint8_t>(std::lround(v * darkening)); });
}

struct FittedText {
    std::string text;
    double height;
};

FittedText fit(std::string text, double height, double width) {
    const double fitted = std::max(smallest_text, std::min(height, height * width / text_width(text, height)));
    if (text_width(text, fitted) > width) {
        while (!text.empty() && text_width(text + "...", fitted) > width) {
            text.pop_back();
        }
        text += text.empty() ? "" : "...";
    }
    return {std::move(text), fitted};
}

/// `text` in a strip's line that begins at row `top`, within `width` columns from `left`.
void draw_line(ByteImage &picture, const std::string &text, int left, int width, double top, double height) {
    const double margin = height / 2;
    const FittedText fitted = fit(text, height, width - 2 * margin);
    const double centred = top + (height * line_spacing - fitted.height) / 2;
    draw_text(picture, left + margin, centred, fitted.height, fitted.text);
}

} // namespace

void draw_labels(ByteImage &picture, Layout layout, int split, std::string_view left, std::string_view right,
                 std::string_view caption) {
    const double height = line_height(picture);
    const double strip = height * line_spacing;
    const int width = picture.size.width;
    const std::string a = "A  " + std::string(left);
    const std::string b = "B  " + std::string(right);
    const int caption_width = std::min(width / 3, static_cast<int>(text_width(caption, height) + height + 1));
    darken(picture, static_cast<int>(layout == Layout::difference ? 2 * strip : strip));
    switch (layout) {
    case Layout::single:
        draw_line(picture, std::string(left), 0, width, 0, height);
        break;
    case Layout::side_by_side:
    case Layout::wipe:
        draw_line(picture, a, 0, split, 0, height);
        draw_line(picture, b, split, width - split, 0, height);
        break;
    case Layout::difference:
        draw_line(picture, a, 0, width - caption_width, 0, height);
        draw_line(picture, b, 0, width - caption_width, strip, height);
        draw_line(picture, std::string(caption), width - caption_width, caption_width, 0, height);
        break;
    }
}

void draw_divider(ByteImage &picture, int split) {
    const int thickness = std::max(1, picture.size.height / 360);
    const int from = std::max(0, split - (thickness + 1) / 2);
    const int to = std::min(picture.size.width, from + thickness);
    for (int y = 0; y < picture.size.height; ++y) {
        const auto row = picture.rgb.begin() + static_cast<std::ptrdiff_t>(3) * y * picture.size.width;
        std::fill(row + static_cast<std::ptrdiff_t>(3) * from, row + static_cast<std::ptrdiff_t>(3) * to,
                  static_cast<std::uint8_t>(255));
    }
}

} // namespace sandbox

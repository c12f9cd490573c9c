#include "image/text.h"

#include "image/glyphs.h"
#include "image/segment.h"
#include "image/system_font.h"

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <sstream>
#include <string>
#include <vector>

namespace sandbox {
namespace {

using Polyline = std::vector<glm::dvec2>;

constexpr double stroke_radius = 1; // in glyph units, as is the gap
constexpr double glyph_gap = 4;
constexpr double space_width = 3;
constexpr int steps_per_curve = 6;

double from_base_36(char c) { return c <= '9' ? c - '0' : c - 'a' + 10; }

Polyline control_points(std::string_view digits) {
    Polyline points;
    for (std::size_t i = 0; i + 1 < digits.size(); i += 2) {
        points.emplace_back(from_base_36(digits[i]), from_base_36(digits[i + 1]));
    }
    return points;
}

/// The quadratic B-spline of the control points: through the ends if open, periodic if the last point is the first.
Polyline curve(const Polyline &control) {
    const std::size_t n = control.size();
    const bool closed = control.front() == control.back();
    const auto middle = [&](std::size_t i) { return (control[i] + control[i + 1]) / 2.0; };
    Polyline points;
    const auto add_arc = [&](glm::dvec2 from, glm::dvec2 bend, glm::dvec2 to) {
        for (int i = 0; i <= steps_per_curve; ++i) {
            const double t = static_cast<double>(i) / steps_per_curve;
            points.push_back((1 - t) * (1 - t) * from + 2 * t * (1 - t) * bend + t * t * to);
        }
    };
    for (std::size_t i = 1; i + 1 < n; ++i) {
        const bool first = i == 1 && !closed;
        const bool last = i + 2 == n && !closed;
        add_arc(first ? control.front() : middle(i - 1), control[i], last ? control.back() : middle(i));
    }
    if (closed) {
        add_arc(middle(n - 2), control.front(), middle(0));
    }
    return points;
}

std::vector<Polyline> strokes_of(char character) {
    std::vector<Polyline> strokes;
    std::istringstream groups{std::string(glyph_strokes(character))};
    for (std::string group; groups >> group;) {
        const bool curved = group.front() == '~';
        const Polyline control = control_points(std::string_view(group).substr(curved ? 1 : 0));
        strokes.push_back(curved ? curve(control) : control);
    }
    return strokes;
}

double advance(const std::vector<Polyline> &strokes) {
    double width = strokes.empty() ? space_width : 0;
    for (const Polyline &stroke : strokes) {
        for (const glm::dvec2 &point : stroke) {
            width = std::max(width, point.x);
        }
    }
    return width + glyph_gap;
}

/// How much of each pixel of a line's box the ink covers; a mask, because strokes that cross must not add up.
struct Mask {
    int left, top;
    Size size;
    std::vector<double> cover;

    Mask(int x, int y, Size s)
        : left(x), top(y), size(s), cover(static_cast<std::size_t>(s.width) * static_cast<std::size_t>(s.height)) {}

    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y - top) * static_cast<std::size_t>(size.width) +
               static_cast<std::size_t>(x - left);
    }

    void add_segment(glm::dvec2 a, glm::dvec2 b, double radius) {
        const auto first = [&](double v, int low) { return std::max(low, static_cast<int>(v - radius - 1)); };
        const auto last = [&](double v, int high) { return std::min(high, static_cast<int>(v + radius + 1)); };
        for (int y = first(std::min(a.y, b.y), top); y <= last(std::max(a.y, b.y), top + size.height - 1); ++y) {
            for (int x = first(std::min(a.x, b.x), left); x <= last(std::max(a.x, b.x), left + size.width - 1); ++x) {
                const double d = distance_to_segment({x + 0.5, y + 0.5}, a, b);
                double &pixel = cover[index(x, y)];
                pixel = std::max(pixel, std::clamp(0.5 + radius - d, 0.0, 1.0));
            }
        }
    }
};

/// The part of a line's box that is inside the picture.
Mask mask_of(const ByteImage &image, double x, double y, double width, double height) {
    const auto inside = [](double v, int high) {
        return static_cast<int>(std::clamp(v, 0.0, static_cast<double>(high)));
    };
    const int left = inside(std::floor(x), image.size.width);
    const int top = inside(std::floor(y), image.size.height);
    const int right = inside(std::ceil(x + width) + 1, image.size.width);
    const int bottom = inside(std::ceil(y + height * (1 + stroke_radius / glyph_top)) + 1, image.size.height);
    return {left, top, {right - left, bottom - top}};
}

void blend(ByteImage &image, const Mask &mask, std::array<std::uint8_t, 3> color) {
    for (int y = mask.top; y < mask.top + mask.size.height; ++y) {
        for (int x = mask.left; x < mask.left + mask.size.width; ++x) {
            const double cover = mask.cover[mask.index(x, y)];
            std::uint8_t *pixel =
                &image.rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.size.width) +
                                static_cast<std::size_t>(x))];
            for (std::size_t c = 0; c < 3; ++c) {
                pixel[c] = static_cast<std::uint8_t>(std::lround(pixel[c] * (1 - cover) + color[c] * cover));
            }
        }
    }
}

} // namespace

namespace {

char stroke_character(char32_t character) { return character < 0x80 ? static_cast<char>(character) : '?'; }

/// In glyph units.
double advance(char32_t character, double height) {
    const auto other = character >= 0x80 ? font_advance(character, height) : std::nullopt;
    return other ? *other * glyph_top / height : advance(strokes_of(stroke_character(character)));
}

void add_glyph(Mask &mask, const GlyphPicture &glyph, double x, double y) {
    const int left = static_cast<int>(std::lround(x + glyph.x)), top = static_cast<int>(std::lround(y + glyph.y));
    for (int v = std::max(0, mask.top - top); v < std::min(glyph.height, mask.top + mask.size.height - top); ++v) {
        for (int u = std::max(0, mask.left - left); u < std::min(glyph.width, mask.left + mask.size.width - left);
             ++u) {
            const auto at =
                static_cast<std::size_t>(v) * static_cast<std::size_t>(glyph.width) + static_cast<std::size_t>(u);
            double &pixel = mask.cover[mask.index(left + u, top + v)];
            pixel = std::max(pixel, glyph.cover[at] / 255.0);
        }
    }
}

} // namespace

double text_width(std::string_view text, double height) {
    double width = 0;
    while (!text.empty()) {
        width += advance(take_character(text), height);
    }
    return std::max(0.0, width - glyph_gap + 2 * stroke_radius) * height / glyph_top;
}

void draw_text(ByteImage &image, double x, double y, double height, std::string_view text,
               std::array<std::uint8_t, 3> color) {
    const double scale = height / glyph_top;
    Mask mask = mask_of(image, x, y, text_width(text, height), height);
    double pen = x + stroke_radius * scale;
    while (!text.empty()) {
        const char32_t character = take_character(text);
        if (const auto glyph = character >= 0x80 ? font_glyph(character, height) : std::nullopt) {
            add_glyph(mask, *glyph, pen, y);
            pen += *font_advance(character, height);
            continue;
        }
        const std::vector<Polyline> strokes = strokes_of(stroke_character(character));
        for (const Polyline &stroke : strokes) {
            for (std::size_t i = 0; i < stroke.size(); ++i) {
                const auto place = [&](glm::dvec2 p) {
                    return glm::dvec2(pen + p.x * scale, y + height - p.y * scale);
                };
                mask.add_segment(place(stroke[i]), place(stroke[std::min(i + 1, stroke.size() - 1)]),
                                 stroke_radius * scale);
            }
        }
        pen += advance(strokes) * scale;
    }
    blend(image, mask, color);
}

} // namespace sandbox

#include "capture/strokes.h"

#include "image/segment.h"
#include "image/text.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

namespace sandbox {
namespace {

constexpr Rgb black{0, 0, 0}, white{255, 255, 255};

/// Covers the pixels whose `distance` to the shape is below 0, with soft edges; only those between `low` and `high`.
template <typename Distance>
void cover(ByteImage &view, glm::dvec2 low, glm::dvec2 high, Rgb color, double opacity, const Distance &distance) {
    const auto inside = [](double v, int most) {
        return static_cast<int>(std::clamp(v, 0.0, static_cast<double>(most)));
    };
    for (int y = inside(low.y - 1, view.size.height); y < inside(high.y + 2, view.size.height); ++y) {
        for (int x = inside(low.x - 1, view.size.width); x < inside(high.x + 2, view.size.width); ++x) {
            const double share = opacity * std::clamp(0.5 - distance(glm::dvec2(x + 0.5, y + 0.5)), 0.0, 1.0);
            const std::size_t at = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(view.size.width) +
                                        static_cast<std::size_t>(x));
            for (std::size_t c = 0; c < 3; ++c) {
                view.rgb[at + c] =
                    static_cast<std::uint8_t>(std::lround(view.rgb[at + c] * (1 - share) + color[c] * share));
            }
        }
    }
}

} // namespace

void draw_line(ByteImage &view, const glm::dvec2 &a, const glm::dvec2 &b, double width, Rgb color, double opacity) {
    const glm::dvec2 reach(width / 2);
    cover(view, glm::min(a, b) - reach, glm::max(a, b) + reach, color, opacity,
          [&](glm::dvec2 p) { return distance_to_segment(p, a, b) - width / 2; });
}

void draw_disc(ByteImage &view, const glm::dvec2 &center, double radius, Rgb color, double opacity) {
    cover(view, center - radius, center + radius, color, opacity,
          [&](glm::dvec2 p) { return glm::distance(p, center) - radius; });
}

void draw_polygon(ByteImage &view, std::span<const glm::dvec2> corners, Rgb color) {
    glm::dvec2 low = corners.front(), high = low;
    for (const glm::dvec2 &corner : corners) {
        low = glm::min(low, corner);
        high = glm::max(high, corner);
    }
    cover(view, low, high, color, 1, [&](glm::dvec2 p) {
        double farthest = -1e300;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const glm::dvec2 from = corners[i], along = glm::normalize(corners[(i + 1) % corners.size()] - from);
            farthest = std::max(farthest, along.y * (p.x - from.x) - along.x * (p.y - from.y));
        }
        return farthest;
    });
}

void draw_hairline(ByteImage &view, const glm::dvec2 &a, const glm::dvec2 &b, double width) {
    draw_line(view, a, b, 3 * width, black, 0.8);
    draw_line(view, a, b, width, white);
}

void draw_ring(ByteImage &view, const glm::dvec2 &center, double radius, double width) {
    for (const auto &[thick, color] : {std::pair(3 * width, black), std::pair(width, white)}) {
        cover(view, center - (radius + thick), center + (radius + thick), color, 1,
              [&, across = thick](glm::dvec2 p) { return std::abs(glm::distance(p, center) - radius) - across / 2; });
    }
}

void draw_arrow(ByteImage &view, const glm::dvec2 &from, const glm::dvec2 &to, double em, Rgb color) {
    const glm::dvec2 along = to - from;
    draw_line(view, from, to, em * 0.28, black, 0.8);
    draw_line(view, from, to, em * 0.14, color);
    if (const double length = glm::length(along); length > em / 2) {
        const glm::dvec2 u = along / length * em / 2.0, side(-u.y, u.x);
        draw_polygon(view, std::array{to + 0.6 * u, to - u + 0.6 * side, to - u - 0.6 * side}, color);
    }
}

void draw_name(ByteImage &view, const glm::dvec2 &at, double em, const std::string &name, Rgb color) {
    draw_text(view, at.x + 1, at.y + 1, em, name, black);
    draw_text(view, at.x, at.y, em, name, color);
}

} // namespace sandbox

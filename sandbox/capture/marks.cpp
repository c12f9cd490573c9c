#include "capture/marks.h"

#include "image/cut_paste.h"
#include "image/segment.h"
#include "image/text.h"
#include "scene/space.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec4.hpp>
#include <initializer_list>

namespace sandbox {
namespace {

using Rgb = std::array<std::uint8_t, 3>;
constexpr Rgb black{0, 0, 0}, white{255, 255, 255};

/// Where a point of the world, given from the eye, lies in the view; none behind the eye.
std::optional<glm::dvec2> projected(const Camera &camera, double aspect, const glm::dvec3 &from_eye) {
    const glm::dvec4 clip = view_projection(camera, aspect) * glm::dvec4(from_eye, 1);
    return clip.w > 0 ? std::optional(glm::dvec2(0.5 + clip.x / clip.w / 2, 0.5 - clip.y / clip.w / 2)) : std::nullopt;
}

/// As bright as can be: a lamp may be dim, its arrow is not.
Rgb bright(const glm::dvec3 &color) {
    const double most = std::max({color.r, color.g, color.b, 1e-9});
    const auto part = [&](double c) { return static_cast<std::uint8_t>(90 + 165 * std::clamp(c / most, 0.0, 1.0)); };
    return {part(color.r), part(color.g), part(color.b)};
}

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

void draw_line(ByteImage &view, glm::dvec2 a, glm::dvec2 b, double width, Rgb color, double opacity = 1) {
    const glm::dvec2 reach(width / 2);
    cover(view, glm::min(a, b) - reach, glm::max(a, b) + reach, color, opacity,
          [&](glm::dvec2 p) { return distance_to_segment(p, a, b) - width / 2; });
}

void draw_triangle(ByteImage &view, const std::array<glm::dvec2, 3> &corners, Rgb color) {
    const auto [a, b, c] = corners;
    cover(view, glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c)), color, 1, [&](glm::dvec2 p) {
        const auto beyond = [&](glm::dvec2 from, glm::dvec2 to) { // clockwise on the screen
            const glm::dvec2 along = glm::normalize(to - from);
            return along.y * (p.x - from.x) - along.x * (p.y - from.y);
        };
        return std::max({beyond(a, b), beyond(b, c), beyond(c, a)});
    });
}

/// A line that is seen on dark and on bright.
void draw_hairline(ByteImage &view, glm::dvec2 a, glm::dvec2 b, double width) {
    draw_line(view, a, b, 3 * width, black, 0.8);
    draw_line(view, a, b, width, white);
}

void draw_ring(ByteImage &view, glm::dvec2 centre, double radius, double width) {
    for (const auto &[thick, color] : {std::pair(3 * width, black), std::pair(width, white)}) {
        cover(view, centre - (radius + thick), centre + (radius + thick), color, 1,
              [&](glm::dvec2 p) { return std::abs(glm::distance(p, centre) - radius) - thick / 2; });
    }
}

void draw_arrow(ByteImage &view, const Arrow &arrow, double em) {
    const glm::dvec2 size(view.size.width, view.size.height);
    const glm::dvec2 from = arrow.from * size, to = arrow.to * size, along = to - from;
    draw_line(view, from, to, em * 0.28, black, 0.8);
    draw_line(view, from, to, em * 0.14, arrow.color);
    if (const double length = glm::length(along); length > em / 2) {
        const glm::dvec2 u = along / length * em / 2.0, side(-u.y, u.x);
        draw_triangle(view, {to + 0.6 * u, to - u + 0.6 * side, to - u - 0.6 * side}, arrow.color);
    }
    const double left = to.x + (along.x >= 0 ? em * 0.4 : -em * 0.4 - text_width(arrow.name, em));
    draw_text(view, left + 1, to.y - em + 1, em, arrow.name, black);
    draw_text(view, left, to.y - em, em, arrow.name, arrow.color);
}

void draw_frame(ByteImage &view, glm::dvec2 low, glm::dvec2 high, Rgb color) {
    const glm::dvec2 other(high.x, low.y), last(low.x, high.y);
    for (const auto &[a, b] :
         {std::pair(low, other), std::pair(other, high), std::pair(high, last), std::pair(last, low)}) {
        draw_line(view, a, b, 1, color);
    }
}

/// Magnifies `plain`, the view without marks.
void draw_loupe(ByteImage &view, const ByteImage &plain, glm::dvec2 pixel, double em) {
    const double width = view.size.width, height = view.size.height;
    const int side = static_cast<int>(std::min({em * 12, width * 0.45, height * 0.45}));
    if (side < loupe_across) {
        return; // no room to magnify anything
    }
    const int x = static_cast<int>(pixel.x * width), y = static_cast<int>(pixel.y * height);
    const auto source = [&](int at, int middle, int size) {
        return std::clamp(middle - loupe_across / 2 + at * loupe_across / side, 0, size - 1);
    };
    ByteImage loupe = black_picture({side, side});
    for (int v = 0; v < side; ++v) {
        for (int u = 0; u < side; ++u) {
            paste(loupe, cut(plain, source(u, x, plain.size.width), source(v, y, plain.size.height), {1, 1}), u, v);
        }
    }
    const double cell = static_cast<double>(side) / loupe_across, middle = cell * (loupe_across / 2);
    draw_frame(loupe, glm::dvec2(middle - 1), glm::dvec2(middle + cell + 1), black);
    draw_frame(loupe, glm::dvec2(middle), glm::dvec2(middle + cell), white);
    draw_frame(loupe, glm::dvec2(0.5), glm::dvec2(side - 0.5), white);
    const int margin = std::min(6, (view.size.height - side) / 2);
    paste(view, loupe, loupe_on_the_right(pixel) ? view.size.width - side - margin : margin, margin);
}

} // namespace

std::vector<Arrow> arrows_of(const Scene &scene, Model model, const PixelProbe &probe, double aspect) {
    const Camera &camera = scene.camera;
    const glm::dvec3 point = probe.position - camera.position;
    const double depth = glm::dot(point, camera_axes(camera).forward);
    const double height =
        is_orthographic(camera) ? camera.height : 2 * depth * std::tan(glm::radians(camera.fov_y_degrees) / 2);
    const double length = 0.25 * height; // of an arrow across the view, as a share of the picture
    const auto from = projected(camera, aspect, point);
    std::vector<Arrow> arrows;
    const auto add = [&](const glm::dvec3 &direction, Rgb color, const std::string &name) {
        const auto to = projected(camera, aspect, point + direction * length);
        if (from && to && direction != glm::dvec3(0)) {
            arrows.push_back({*from, *to, color, name});
        }
    };
    for (const reference::LightProbe &light : probe.lights) {
        const Rgb color = bright(scene.lights[light.light].color);
        const std::string number = probe.lights.size() > 1 ? fmt::format("{}", light.light + 1) : "";
        if (model == Model::phong) {
            add(light.terms.vectors.r, color, "R" + number);
        } else if (model == Model::blinn_phong) {
            add(light.terms.vectors.h, color, "H" + number);
        }
        add(light.terms.vectors.l, color, "L" + number);
    }
    add(probe.view, {190, 190, 190}, "V");
    add(probe.normal, white, "N");
    return arrows;
}

bool loupe_on_the_right(const glm::dvec2 &pixel) { return pixel.x < 0.5 || pixel.y > 0.5; }

void draw_marks(ByteImage &view, const Marks &marks, const std::vector<Arrow> &arrows, double em) {
    const ByteImage plain = view;
    const double width = view.size.width, height = view.size.height;
    const double hair = std::max(1.0, height / 1000);
    if (marks.profile) {
        const double y = *marks.profile * height;
        draw_hairline(view, {-1, y}, {width + 1, y}, hair);
    }
    if (marks.pixel && marks.vectors) {
        for (const Arrow &arrow : arrows) {
            draw_arrow(view, arrow, em);
        }
        const glm::dvec2 at = *marks.pixel * glm::dvec2(width, height);
        draw_hairline(view, at - glm::dvec2(0.6 * em, 0), at + glm::dvec2(0.6 * em, 0), hair);
        draw_hairline(view, at - glm::dvec2(0, 0.6 * em), at + glm::dvec2(0, 0.6 * em), hair);
    }
    if (marks.pixel && marks.loupe) {
        draw_loupe(view, plain, *marks.pixel, em);
    }
    if (marks.ring) {
        draw_ring(view, glm::dvec2(*marks.ring) * glm::dvec2(width, height), marks.ring->z * height, 2 * hair);
    }
}

} // namespace sandbox

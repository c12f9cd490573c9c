#include "capture/marks.h"

#include "image/cut_paste.h"
#include "image/text.h"
#include "scene/space.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <initializer_list>

namespace sandbox {
namespace {

constexpr Rgb black{0, 0, 0}, white{255, 255, 255};

/// As bright as can be: a lamp may be dim, its arrow is not.
Rgb bright(const glm::dvec3 &color) {
    const double most = std::max({color.r, color.g, color.b, 1e-9});
    const auto part = [&](double c) { return static_cast<std::uint8_t>(90 + 165 * std::clamp(c / most, 0.0, 1.0)); };
    return {part(color.r), part(color.g), part(color.b)};
}

void draw_vector(ByteImage &view, const Arrow &arrow, double em) {
    const glm::dvec2 size(view.size.width, view.size.height);
    const glm::dvec2 to = arrow.to * size;
    draw_arrow(view, arrow.from * size, to, em, arrow.color);
    const bool right = arrow.to.x >= arrow.from.x;
    draw_name(view, {to.x + (right ? em * 0.4 : -em * 0.4 - text_width(arrow.name, em)), to.y - em}, em, arrow.name,
              arrow.color);
}

void draw_light(ByteImage &view, const Words &words, const LightMark &light, double em) {
    const glm::dvec2 size(view.size.width, view.size.height);
    const LightGizmo &gizmo = light.gizmo;
    for (const auto &[color, width] : {std::pair(black, 0.2 * em), std::pair(light.color, 0.09 * em)}) {
        for (const std::vector<glm::dvec2> &line : gizmo.lines) {
            for (std::size_t i = 1; i < line.size(); ++i) {
                draw_line(view, line[i - 1] * size, line[i] * size, width, color);
            }
        }
    }
    if (gizmo.from && gizmo.to) {
        draw_arrow(view, *gizmo.from * size, *gizmo.to * size, em, light.color);
    }
    const glm::dvec2 lamp = gizmo.lamp * size;
    draw_disc(view, lamp, (lamp_radius + 0.12) * em, black, 0.8);
    draw_disc(view, lamp, lamp_radius * em, light.color);
    if (light.named) {
        const std::string name = words.format("light.numbered", gizmo.light + 1);
        const glm::dvec2 beside = lamp + glm::dvec2((lamp_radius + 0.6) * em, 0);
        draw_line(view, beside, beside + glm::dvec2(text_width(name, em), 0), 1.2 * em, black, 0.6);
        draw_name(view, beside - glm::dvec2(0, 0.5 * em), em, name, white);
    }
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
    // Of an arrow across the view, as a share of the picture.
    const double length = 0.25 * view_height(camera, glm::dot(point, camera_axes(camera).forward));
    const auto from = place_in_view(camera, aspect, point);
    std::vector<Arrow> arrows;
    const auto add = [&](const glm::dvec3 &direction, Rgb color, const std::string &name) {
        const auto to = place_in_view(camera, aspect, point + direction * length);
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

std::vector<LightMark> light_marks(const Scene &scene, double aspect) {
    const auto on = std::ranges::count_if(scene.lights, &Light::enabled);
    std::vector<LightMark> marks;
    for (const LightGizmo &gizmo : light_gizmos(scene, aspect)) {
        marks.push_back({gizmo, bright(scene.lights[gizmo.light].color), on > 1});
    }
    return marks;
}

void draw_marks(ByteImage &view, const Words &words, const Marks &marks, const std::vector<Arrow> &arrows, double em,
                const std::vector<LightMark> &lights) {
    const ByteImage plain = view;
    const double width = view.size.width, height = view.size.height;
    const double hair = std::max(1.0, height / 1000);
    if (marks.profile) {
        const double y = *marks.profile * height;
        draw_hairline(view, {-1, y}, {width + 1, y}, hair);
    }
    for (const LightMark &light : lights) {
        draw_light(view, words, light, em);
    }
    if (marks.pixel && marks.vectors) {
        for (const Arrow &arrow : arrows) {
            draw_vector(view, arrow, em);
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

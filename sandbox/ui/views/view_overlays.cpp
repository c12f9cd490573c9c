#include "ui/views/view_overlays.h"

#include "scene/space.h"
#include "ui/widgets/widgets.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec4.hpp>
#include <string>

namespace sandbox {

namespace {

constexpr ImU32 dark = IM_COL32(0, 0, 0, 200);
constexpr ImU32 white = IM_COL32(255, 255, 255, 255);

ImVec2 place_of(const Rect &picture, const glm::dvec2 &share) {
    return {picture.low.x + static_cast<float>(share.x) * picture.width(),
            picture.low.y + static_cast<float>(share.y) * picture.height()};
}

/// Where a point of the world, given from the eye, lies in the picture; none behind the eye.
std::optional<ImVec2> projected(const Camera &camera, const Rect &picture, const glm::dvec3 &from_eye) {
    const double aspect = static_cast<double>(picture.width()) / static_cast<double>(picture.height());
    const glm::dvec4 clip = view_projection(camera, aspect) * glm::dvec4(from_eye, 1);
    if (clip.w <= 0) {
        return {};
    }
    return place_of(picture, {0.5 + clip.x / clip.w / 2, 0.5 - clip.y / clip.w / 2});
}

void draw_arrow(ImVec2 from, ImVec2 to, ImU32 color, const std::string &name) {
    ImDrawList &list = *ImGui::GetWindowDrawList();
    const float em = ImGui::GetFontSize();
    const float dx = to.x - from.x, dy = to.y - from.y;
    const float length = std::hypot(dx, dy);
    list.AddLine(from, to, dark, em * 0.28F);
    list.AddLine(from, to, color, em * 0.14F);
    if (length > em * 0.5F) {
        const float ux = dx / length * em * 0.5F, uy = dy / length * em * 0.5F;
        list.AddTriangleFilled({to.x + ux * 0.6F, to.y + uy * 0.6F}, {to.x - ux - uy * 0.6F, to.y - uy + ux * 0.6F},
                               {to.x - ux + uy * 0.6F, to.y - uy - ux * 0.6F}, color);
    }
    const ImVec2 at{to.x + (dx >= 0 ? em * 0.4F : -em * 0.4F - ImGui::CalcTextSize(name.c_str()).x), to.y - em};
    list.AddText({at.x + 1, at.y + 1}, dark, name.c_str());
    list.AddText(at, color, name.c_str());
}

/// As bright as can be: a lamp may be dim, its arrow is not.
ImU32 bright(const glm::dvec3 &color) {
    const double most = std::max({color.r, color.g, color.b, 1e-9});
    const auto part = [&](double c) { return static_cast<int>(90 + 165 * std::clamp(c / most, 0.0, 1.0)); };
    return IM_COL32(part(color.r), part(color.g), part(color.b), 255);
}

void draw_vectors(const PixelFindings &found, const ProbedPixel &truth, const Rect &picture) {
    const Camera &camera = found.of.scene.camera;
    const glm::dvec3 point = truth.probe.position - camera.position;
    const double depth = glm::dot(point, camera_axes(camera).forward);
    const double height =
        is_orthographic(camera) ? camera.height : 2 * depth * std::tan(glm::radians(camera.fov_y_degrees) / 2);
    const double length = 0.25 * height; // of an arrow across the view, as a share of the picture
    const auto from = projected(camera, picture, point);
    const auto arrow = [&](const glm::dvec3 &direction, ImU32 color, const std::string &name) {
        const auto to = projected(camera, picture, point + direction * length);
        if (from && to && direction != glm::dvec3(0)) {
            draw_arrow(*from, *to, color, name);
        }
    };
    for (const reference::LightProbe &light : truth.probe.lights) {
        const ImU32 color = bright(found.of.scene.lights[light.light].color);
        const std::string number = truth.probe.lights.size() > 1 ? fmt::format("{}", light.light + 1) : "";
        if (found.of.left.model == Model::phong) {
            arrow(light.terms.vectors.r, color, "R" + number);
        } else if (found.of.left.model == Model::blinn_phong) {
            arrow(light.terms.vectors.h, color, "H" + number);
        }
        arrow(light.terms.vectors.l, color, "L" + number);
    }
    arrow(truth.probe.view, IM_COL32(190, 190, 190, 255), "V");
    arrow(truth.probe.normal, white, "N");
}

} // namespace

void draw_probe(const Session &session, const Rect &picture) {
    const auto at = session.view.probed();
    if (session.view.overlay != Overlay::pixel || !at) {
        return;
    }
    ImDrawList &list = *ImGui::GetWindowDrawList();
    list.PushClipRect(picture.low, picture.high, true);
    if (const PixelFindings *found = session.pixel.get(); found != nullptr && (*found)[Probed::truth_of_a]) {
        draw_vectors(*found, *(*found)[Probed::truth_of_a], picture);
    }
    const ImVec2 place = place_of(picture, *at);
    const float arm = ImGui::GetFontSize() * 0.6F;
    for (const auto &[color, thickness] : {std::pair(dark, 3.0F), std::pair(white, 1.0F)}) {
        list.AddLine({place.x - arm, place.y}, {place.x + arm, place.y}, color, thickness);
        list.AddLine({place.x, place.y - arm}, {place.x, place.y + arm}, color, thickness);
    }
    list.PopClipRect();
}

void draw_profile_line(const Session &session, const Rect &picture) {
    if (session.view.overlay != Overlay::profile) {
        return;
    }
    const float y = picture.low.y + static_cast<float>(session.view.profile_row) * picture.height();
    ImDrawList &list = *ImGui::GetWindowDrawList();
    list.AddLine({picture.low.x, y}, {picture.high.x, y}, dark, 3);
    list.AddLine({picture.low.x, y}, {picture.high.x, y}, white, 1);
}

void draw_loupe(const Session &session, const Rect &picture, unsigned texture) {
    const auto at = session.view.probed();
    if (!session.view.loupe || !at || texture == 0) {
        return;
    }
    constexpr int across = 21; // pixels, odd: the probed one is in the middle
    const float side =
        std::floor(std::min({ImGui::GetFontSize() * 12, picture.width() * 0.45F, picture.height() * 0.45F}));
    const ImVec2 framebuffer = ImGui::GetIO().DisplayFramebufferScale;
    const double width = static_cast<double>(picture.width() * framebuffer.x);
    const double height = static_cast<double>(picture.height() * framebuffer.y);
    const double x = std::floor(at->x * width), y = std::floor(at->y * height);
    const auto u = [&](double pixel) { return static_cast<float>(pixel / width); };
    const auto v = [&](double pixel) { return static_cast<float>(1 - pixel / height); }; // bottom row first
    const bool on_the_right = at->x < 0.5 || at->y > 0.5;
    const ImVec2 low{on_the_right ? picture.high.x - side - 6 : picture.low.x + 6, picture.low.y + 6};
    const ImVec2 high{low.x + side, low.y + side};
    ImDrawList &list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({low.x - 2, low.y - 2}, {high.x + 2, high.y + 2}, white);
    list.AddImage(texture_id(texture), low, high, {u(x - across / 2), v(y - across / 2)},
                  {u(x + across / 2 + 1), v(y + across / 2 + 1)});
    const float cell = side / across;
    const ImVec2 middle{low.x + cell * (across / 2), low.y + cell * (across / 2)};
    list.AddRect({middle.x - 1, middle.y - 1}, {middle.x + cell + 1, middle.y + cell + 1}, dark);
    list.AddRect(middle, {middle.x + cell, middle.y + cell}, white);
}

} // namespace sandbox

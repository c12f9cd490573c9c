#include "ui/views/view_overlays.h"

#include "capture/marks.h"
#include "ui/widgets/widgets.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace sandbox {

namespace {

constexpr ImU32 dark = IM_COL32(0, 0, 0, 200);
constexpr ImU32 white = IM_COL32(255, 255, 255, 255);

void draw_vectors(const PixelFindings &found, const Rect &picture) {
    const double aspect = static_cast<double>(picture.width()) / static_cast<double>(picture.height());
    const PixelProbe &truth = found[Probed::truth_of_a]->probe;
    for (const Arrow &arrow : arrows_of(found.of.scene, found.of.truth_of_side(false).model, truth, aspect)) {
        draw_arrow(place_of(picture, arrow.from), place_of(picture, arrow.to),
                   IM_COL32(arrow.color[0], arrow.color[1], arrow.color[2], 255), arrow.name);
    }
}

} // namespace

ImVec2 place_of(const Rect &picture, const glm::dvec2 &share) {
    return {picture.low.x + static_cast<float>(share.x) * picture.width(),
            picture.low.y + static_cast<float>(share.y) * picture.height()};
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

void draw_probe(const Session &session, const Rect &picture) {
    const auto at = session.view.probed();
    if (session.view.overlay != Overlay::pixel || !at) {
        return;
    }
    ImDrawList &list = *ImGui::GetWindowDrawList();
    list.PushClipRect(picture.low, picture.high, true);
    if (const PixelFindings *found = session.pixel.get(); found != nullptr && (*found)[Probed::truth_of_a]) {
        draw_vectors(*found, picture);
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

void draw_ring(const Session &session, const Rect &picture) {
    const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
    const auto pixels = [](float length) { return std::max(1, static_cast<int>(std::lround(length))); };
    const auto ring = shown_ring(session, {pixels(picture.width() * scale.x), pixels(picture.height() * scale.y)});
    if (!ring) {
        return;
    }
    ImDrawList &list = *ImGui::GetWindowDrawList();
    list.PushClipRect(picture.low, picture.high, true);
    const ImVec2 middle = place_of(picture, *ring);
    const float radius = static_cast<float>(ring->z) * picture.height();
    const float hair = std::max(2.0F, ImGui::GetFontSize() * 0.14F);
    list.AddCircle(middle, radius, dark, 0, 2 * hair);
    list.AddCircle(middle, radius, white, 0, hair);
    list.PopClipRect();
}

void draw_loupe(const Session &session, const Rect &picture, unsigned texture) {
    const auto at = session.view.probed();
    if (!session.view.loupe || !at || texture == 0) {
        return;
    }
    constexpr int across = loupe_across;
    const float side =
        std::floor(std::min({ImGui::GetFontSize() * 12, picture.width() * 0.45F, picture.height() * 0.45F}));
    const ImVec2 framebuffer = ImGui::GetIO().DisplayFramebufferScale;
    const double width = static_cast<double>(picture.width() * framebuffer.x);
    const double height = static_cast<double>(picture.height() * framebuffer.y);
    const double x = std::floor(at->x * width), y = std::floor(at->y * height);
    const auto u = [&](double pixel) { return static_cast<float>(pixel / width); };
    const auto v = [&](double pixel) { return static_cast<float>(1 - pixel / height); }; // bottom row first
    const bool on_the_right = loupe_on_the_right(*at);
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

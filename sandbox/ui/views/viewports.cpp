#include "ui/views/viewports.h"

#include "render/blit.h"
#include "render/gl_state.h"
#include "ui/session/own_files.h"
#include "ui/views/difference_scale.h"
#include "ui/views/light_handles.h"
#include "ui/views/view_captions.h"
#include "ui/views/view_mouse.h"
#include "ui/views/view_overlays.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <algorithm>
#include <cmath>
#include <imgui.h>
#include <string>

namespace sandbox {

namespace {

struct Arrangement {
    Rect pictures;
    float gap = 0; ///< between two pictures
    int columns = 1;
    [[nodiscard]] Rect column(int i) const {
        const float each = (pictures.width() - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns);
        const float left = pictures.low.x + (std::floor(each) + gap) * static_cast<float>(i);
        return {{left, pictures.low.y}, {left + std::floor(each), pictures.high.y}};
    }
};

/// The same rows in every layout.
Arrangement arrange(const Session &session) {
    Arrangement arrangement;
    arrangement.columns = columns_of(session.view.layout);
    arrangement.gap = 4;
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const float top = low.y + captions_above();
    arrangement.pictures = {{low.x, top},
                            {low.x + std::max(room.x, 16.0F), std::max(low.y + room.y - captions_below(), top + 16)}};
    return arrangement;
}

Size pixels_of(const Rect &rect) {
    const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale; // larger than 1 on dense screens
    const auto pixels = [](float length) { return std::clamp(static_cast<int>(std::lround(length)), 1, 8192); };
    return {pixels(rect.width() * scale.x), pixels(rect.height() * scale.y)};
}

/// As an ImDrawCallback: the command's texture fills its clip rectangle.
void blit_picture(const ImDrawList * /*list*/, const ImDrawCmd *command) {
    const ImDrawData &data = *ImGui::GetDrawData();
    const auto pixels = [](float length, float scale) { return static_cast<int>(std::lround(length * scale)); };
    const ImVec4 &clip = command->ClipRect;
    const int left = pixels(clip.x - data.DisplayPos.x, data.FramebufferScale.x);
    const int right = pixels(clip.z - data.DisplayPos.x, data.FramebufferScale.x);
    const int top = pixels(clip.y - data.DisplayPos.y, data.FramebufferScale.y);
    const int bottom = pixels(clip.w - data.DisplayPos.y, data.FramebufferScale.y);
    const int height = pixels(data.DisplaySize.y, data.FramebufferScale.y);
    blit_texture(texture_name(command->UserCallbackData), {left, height - bottom, right - left, bottom - top});
}

/// The part of a picture between two shares of its width.
void draw_picture_part(const Rect &rect, unsigned texture, float from, float to) {
    if (from == 0 && to == 1 && !is_es()) { // ES 3.0 does not tell how large a texture is
        ImDrawList &list = *ImGui::GetWindowDrawList();
        list.PushClipRect(rect.low, rect.high);
        list.AddCallback(blit_picture, texture_id(texture));
        list.PopClipRect();
        return;
    }
    const ImVec2 low{rect.low.x + rect.width() * from, rect.low.y};
    const ImVec2 high{rect.low.x + rect.width() * to, rect.high.y};
    ImGui::GetWindowDrawList()->AddImage(texture_id(texture), low, high, {from, 1}, {to, 0});
}

/// In place of a picture that could not be drawn.
void draw_error(const Rect &rect, const std::string &text, bool whole) {
    const float margin = ImGui::GetFontSize();
    const float wrap = std::max(rect.width() - 2 * margin, 60.0F);
    ImDrawList &list = *ImGui::GetWindowDrawList();
    const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, wrap);
    const ImVec2 high{rect.high.x, whole ? rect.high.y : std::min(rect.high.y, rect.low.y + size.y + 2 * margin)};
    list.AddRectFilled(rect.low, high, ImGui::GetColorU32(ImGuiCol_PopupBg));
    list.PushClipRect(rect.low, rect.high, true);
    list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {rect.low.x + margin, rect.low.y + margin},
                 ImGui::GetColorU32(error_text()), text.c_str(), nullptr, wrap);
    list.PopClipRect();
}

std::string why_absent(const Session &session, const PaintedView &view) {
    return view.error.empty() ? session.text("view.awaited") : view.error;
}

void draw_view(const Session &session, const ViewPainter &painter, bool right, const Rect &rect, float from = 0,
               float to = 1) {
    const PaintedView &view = painter.view(right);
    if (view.texture != 0) {
        const unsigned masks = painter.mask_texture(right);
        draw_picture_part(rect, masks != 0 ? masks : view.texture, from, to);
    } else {
        const Rect part{{rect.low.x + rect.width() * from, rect.low.y}, {rect.low.x + rect.width() * to, rect.high.y}};
        draw_error(part, why_absent(session, view), true);
    }
    const std::string own = own_failure(session, right);
    if (const std::string &warning = own.empty() ? view.warning : own; !warning.empty()) {
        draw_error(rect, warning, false);
    }
}

/// The first two columns.
void show_side_by_side(Session &session, const ViewPainter &painter, const Arrangement &arrangement) {
    for (const bool right : {false, true}) {
        const Rect rect = arrangement.column(right ? 1 : 0);
        draw_view(session, painter, right, rect);
        draw_mask_legend(session, painter, rect, right, false);
        draw_captions(session, painter, rect, right, false);
    }
}

Rect left_half(const Rect &rect) { return {rect.low, {(rect.low.x + rect.high.x) / 2, rect.high.y}}; }
Rect right_half(const Rect &rect) { return {{(rect.low.x + rect.high.x) / 2, rect.low.y}, rect.high}; }

void show_wipe(Session &session, const ViewPainter &painter, const Rect &rect) {
    const float x = divider_x(session, rect);
    const float share = (x - rect.low.x) / rect.width();
    draw_view(session, painter, false, rect, 0, share);
    draw_view(session, painter, true, rect, share, 1);
    draw_mask_legend(session, painter, left_half(rect), false, false);
    draw_mask_legend(session, painter, right_half(rect), true, true);
    ImDrawList &list = *ImGui::GetWindowDrawList();
    const float middle = (rect.low.y + rect.high.y) / 2;
    const float grip = ImGui::GetFontSize() * 0.45F;
    list.AddRectFilled({x - 1.5F, rect.low.y}, {x + 1.5F, rect.high.y}, IM_COL32(255, 255, 255, 230));
    list.AddCircleFilled({x, middle}, grip + 2, IM_COL32(20, 24, 28, 255));
    list.AddCircleFilled({x, middle}, grip, IM_COL32(255, 255, 255, 255));
    describe_text(session, "View/divider", {x - grip, middle - grip}, {x + grip, middle + grip}, "");
    draw_captions(session, painter, left_half(rect), false, false);
    draw_captions(session, painter, right_half(rect), true, true);
}

void show_flip(Session &session, const ViewPainter &painter, const Rect &rect) {
    const bool right = session.view.show_right;
    draw_view(session, painter, right, rect);
    draw_mask_legend(session, painter, rect, right, false);
    draw_captions(session, painter, rect, right, false);
    draw_text_line(session, "View/hint", rect, rect.low.y - ImGui::GetFrameHeight(), quiet_text(),
                   right ? "" : session.text("view.hold_space"), true);
}

void say_truth_is_awaited(Session &session, const Rect &rect) {
    draw_text_line(session, "Truth/state", rect, rect.low.y, quiet_text(), session.text("view.truth_awaited"), false);
}

/// The reference of A's model.
void draw_truth(Session &session, const ViewPainter &painter, const Rect &rect) {
    if (const unsigned texture = painter.truth_texture(false); texture != 0) {
        draw_picture_part(rect, texture, 0, 1);
    } else {
        ImGui::GetWindowDrawList()->AddRectFilled(rect.low, rect.high, ImGui::GetColorU32(ImGuiCol_FrameBg));
        say_truth_is_awaited(session, rect);
    }
    draw_truth_captions(session, rect, false);
}

void show_three_up(Session &session, const ViewPainter &painter, const Arrangement &arrangement) {
    show_side_by_side(session, painter, arrangement);
    draw_truth(session, painter, arrangement.column(2));
}

void show_difference(Session &session, const ViewPainter &painter, const Rect &rect) {
    const DifferenceOf of = session.view.difference_of;
    if (painter.difference_texture() != 0) {
        draw_picture_part(rect, painter.difference_texture(), 0, 1);
        difference_scale(session, rect);
    } else if (of != DifferenceOf::a_b && painter.view(of == DifferenceOf::b_truth).error.empty()) {
        say_truth_is_awaited(session, rect);
    } else {
        const bool right = painter.view(false).error.empty() && !painter.view(true).error.empty();
        draw_error(rect, why_absent(session, painter.view(right)), true);
    }
    difference_controls(session, painter, rect);
    if (of != DifferenceOf::b_truth) {
        draw_captions(session, painter, left_half(rect), false, false, false);
    }
    if (of != DifferenceOf::a_truth) {
        draw_captions(session, painter, right_half(rect), true, true, false);
    }
    if (of != DifferenceOf::a_b) {
        draw_truth_captions(session, of == DifferenceOf::b_truth ? left_half(rect) : right_half(rect),
                            of == DifferenceOf::b_truth);
    }
}

void show_layout(Session &session, const ViewPainter &painter, const Arrangement &arrangement) {
    const Rect rect = arrangement.column(0);
    switch (session.view.layout) {
    case Layout::side_by_side:
        return show_side_by_side(session, painter, arrangement);
    case Layout::three_up:
        return show_three_up(session, painter, arrangement);
    case Layout::wipe:
        return show_wipe(session, painter, rect);
    case Layout::single:
        return show_flip(session, painter, rect);
    case Layout::difference:
        return show_difference(session, painter, rect);
    }
}

/// What a column shows, for the loupe. Of a wipe the side under the pixel.
unsigned texture_of(const Session &session, const ViewPainter &painter, int column) {
    const auto side = [&](bool right) {
        const unsigned masks = painter.mask_texture(right);
        return masks != 0 ? masks : painter.view(right).texture;
    };
    switch (session.view.layout) {
    case Layout::difference:
        return painter.difference_texture();
    case Layout::single:
        return side(session.view.show_right);
    case Layout::wipe:
        return side(session.view.probed().value_or(glm::dvec2(0)).x > static_cast<double>(session.view.divider));
    case Layout::side_by_side:
    case Layout::three_up:
        break;
    }
    return column == 2 ? painter.truth_texture(false) : side(column == 1);
}

} // namespace

void viewports(Session &session, ViewPainter &painter) {
    const Arrangement arrangement = arrange(session);
    draw_header(session, painter, ImGui::GetCursorScreenPos(), arrangement.pictures.width());
    constexpr const char *names[] = {"A", "B", "Truth"};
    session.view.hovered_pixel.reset();
    for (int i = 0; i < arrangement.columns; ++i) {
        mouse_over_picture(session, arrangement.column(i), arrangement.columns == 1 ? "View" : names[i]);
    }
    const Rect rect = arrangement.column(0);
    const bool moving = ImGui::IsAnyItemActive() || session.playback.playing;
    painter.paint(session, pixels_of(rect), moving);
    session.triangles = {painter.triangles(false), painter.triangles(true)};
    session.same_picture = painter.same_picture(shown_document(session));
    if (!moving) {
        painter.measure_difference();
    }
    show_layout(session, painter, arrangement);
    if (painter.awaited() != nullptr) {
        draw_text_line(session, "View/pending", arrangement.pictures, arrangement.pictures.low.y, quiet_text(),
                       session.text("view.pending"), true);
    }
    for (int i = 0; i < arrangement.columns; ++i) {
        draw_profile_line(session, arrangement.column(i));
        {
            const ScopedName name(session, arrangement.columns == 1 ? "View" : names[i]);
            draw_lights(session, arrangement.column(i));
        }
        draw_ring(session, arrangement.column(i));
        draw_probe(session, arrangement.column(i));
        draw_loupe(session, arrangement.column(i), texture_of(session, painter, i));
    }
}

} // namespace sandbox

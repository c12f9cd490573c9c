#include "ui/views/viewports.h"

#include "capture/picture.h"
#include "ui/views/difference_scale.h"
#include "ui/views/view_mouse.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>
#include <string>
#include <utility>
#include <vector>

namespace sandbox {

namespace {

/// A line of names above the pictures, a line of figures below.
struct Arrangement {
    Rect pictures;
    float line = 0;
    float gap = 0; ///< between two pictures
    int columns = 1;
    [[nodiscard]] Rect column(int i) const {
        const float each = (pictures.width() - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns);
        const float left = pictures.low.x + (std::floor(each) + gap) * static_cast<float>(i);
        return {{left, pictures.low.y}, {left + std::floor(each), pictures.high.y}};
    }
};

Arrangement arrange(const Session &session) {
    Arrangement arrangement;
    arrangement.columns = session.view.layout == Layout::side_by_side ? 2 : 1;
    arrangement.line = ImGui::GetFrameHeight();
    arrangement.gap = 4;
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const float below = session.view.layout == Layout::difference ? difference_scale_height() : arrangement.line;
    const float bottom = std::max(low.y + room.y - below, low.y + arrangement.line + 16);
    arrangement.pictures = {{low.x, low.y + arrangement.line}, {low.x + std::max(room.x, 16.0F), bottom}};
    return arrangement;
}

Size pixels_of(const Rect &rect) {
    const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale; // larger than 1 on dense screens
    const auto pixels = [](float length) { return std::clamp(static_cast<int>(std::lround(length)), 1, 8192); };
    return {pixels(rect.width() * scale.x), pixels(rect.height() * scale.y)};
}

/// The part of a picture between two shares of its width.
void draw_picture_part(const Rect &rect, unsigned texture, float from, float to) {
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

void draw_view(const ViewPainter &painter, bool right, const Rect &rect, float from = 0, float to = 1) {
    const PaintedView &view = painter.view(right);
    if (view.texture != 0) {
        const unsigned masks = painter.masks(right).texture;
        draw_picture_part(rect, masks != 0 ? masks : view.texture, from, to);
    } else {
        const Rect part{{rect.low.x + rect.width() * from, rect.low.y}, {rect.low.x + rect.width() * to, rect.high.y}};
        draw_error(part, view.error, true);
    }
    if (!view.warning.empty()) {
        draw_error(rect, view.warning, false);
    }
}

/// A line of text at the left or right of `rect`, clipped to it. Scripts call it `name`.
void draw_text_line(Session &session, const std::string &name, const Rect &rect, float y, ImVec4 color,
                    const std::string &text, bool align_right) {
    constexpr float margin = 6;
    const float left = rect.low.x + margin;
    const float x = align_right ? std::max(left, rect.high.x - margin - ImGui::CalcTextSize(text.c_str()).x) : left;
    ImDrawList &list = *ImGui::GetWindowDrawList();
    list.PushClipRect({x, y}, {rect.high.x, y + ImGui::GetFrameHeight()}, true);
    list.AddText({x, y + ImGui::GetStyle().FramePadding.y}, ImGui::GetColorU32(color), text.c_str());
    list.PopClipRect();
    describe_text(session, name, {x, y}, {rect.high.x, y + ImGui::GetFrameHeight()}, text);
}

/// "A  per-vertex / phong", then what differs from the defaults.
std::string side_name(const Session &session, bool right) {
    const bool textbook = !right && session.document.left_is_textbook();
    std::string text = textbook ? textbook_name(session.document.left) : to_string(session.technique(right));
    if (const auto slash = text.find('/'); slash != std::string::npos) {
        text.replace(slash, 1, " / ");
    }
    if (const auto colon = text.find(':'); colon != std::string::npos) {
        text.replace(colon, 1, "    ");
    }
    return (right ? "B   " : "A   ") + text + (right && session.same_picture ? "    (the same picture as A)" : "");
}

std::string time_text(const Session &session, const PaintedView &view) {
    return view.texture != 0 && session.appearance.run_times
               ? fmt::format("{:.{}f} ms", view.milliseconds, view.milliseconds < 10 ? 1 : 0)
               : "";
}

/// Empty if all pixels are finite.
std::string nonfinite_text(const PaintedView &view) {
    if (view.texture == 0 || view.nonfinite == 0) {
        return "";
    }
    return fmt::format("{} non-finite pixel{}", view.nonfinite, view.nonfinite == 1 ? "" : "s");
}

/// Run time and, on a line of its own if `stacked`, what is wrong with the picture.
void draw_figures(Session &session, const PaintedView &view, const std::string &side, const Rect &rect, float y,
                  bool align_right, bool stacked) {
    const std::string time = time_text(session, view);
    const std::string wrong = nonfinite_text(view);
    draw_text_line(session, side + "/time", rect, y, ImGui::GetStyleColorVec4(ImGuiCol_Text), time, align_right);
    if (wrong.empty()) {
        return;
    }
    if (stacked) {
        return draw_text_line(session, side + "/wrong", rect, y + ImGui::GetFrameHeight(), error_text(), wrong,
                              align_right);
    }
    const float gap = ImGui::GetFontSize();
    Rect beside = rect; // the time does not move
    (align_right ? beside.high.x : beside.low.x) +=
        (align_right ? -1.0F : 1.0F) * (ImGui::CalcTextSize(time.c_str()).x + gap);
    draw_text_line(session, side + "/wrong", beside, y, error_text(), wrong, align_right);
}

/// The technique above the picture, its figures `below` lines under it.
void draw_names(Session &session, const ViewPainter &painter, const Rect &rect, bool right, bool align_right,
                float below = 0) {
    const float line = ImGui::GetFrameHeight();
    const std::string side = right ? "B" : "A";
    draw_text_line(session, side + "/name", rect, rect.low.y - line, side_color(right), side_name(session, right),
                   align_right);
    draw_figures(session, painter.view(right), side, rect, rect.high.y + below * line, align_right, below > 0);
}

/// In the lower corner of a picture of masks: what each colour means, how many pixels, the largest error under them.
void draw_mask_legend(const Session &session, const ViewPainter &painter, const Rect &rect, bool right,
                      bool align_right) {
    if (!session.view.masks || painter.view(right).texture == 0) {
        return;
    }
    const PaintedMasks &found = painter.masks(right);
    std::vector<std::pair<ImU32, std::string>> lines;
    if (!found.metrics) {
        lines.emplace_back(0, found.progress < 1 ? fmt::format("masks: {:.0f} %", found.progress * 100) : "masks");
    } else {
        const Metrics &metrics = *found.metrics;
        const double share = metrics.compared_share;
        lines.emplace_back(0, std::isnan(share) ? "against its reference: nothing is shown"
                                                : fmt::format("against its reference: {:.1f} % compared", 100 * share));
        for (const Mask &mask : masks) {
            const std::size_t pixels = metrics.*mask.pixels;
            const auto [r, g, b] = mask.color;
            lines.emplace_back(IM_COL32(r, g, b, 255), pixels == 0
                                                           ? fmt::format("{}: none", mask.name)
                                                           : fmt::format("{}: {} pixels, error up to {:.2g}", mask.name,
                                                                         pixels, metrics.*mask.max_abs));
        }
    }
    const float line = ImGui::GetTextLineHeightWithSpacing();
    const float em = ImGui::GetFontSize();
    float width = 0;
    for (const auto &[color, text] : lines) {
        width = std::max(width, ImGui::CalcTextSize(text.c_str()).x + (color != 0 ? em * 1.2F : 0));
    }
    const ImVec2 size{width + em, line * static_cast<float>(lines.size()) + em * 0.5F};
    const float x = align_right ? rect.high.x - size.x : rect.low.x;
    float y = rect.high.y - size.y;
    ImDrawList &list = *ImGui::GetWindowDrawList();
    list.PushClipRect(rect.low, rect.high, true);
    list.AddRectFilled({x, y}, {x + size.x, y + size.y}, IM_COL32(16, 18, 22, 235));
    y += em * 0.3F;
    for (const auto &[color, text] : lines) {
        const float left = x + em * 0.5F;
        if (color != 0) {
            list.AddRectFilled({left, y + em * 0.15F}, {left + em * 0.8F, y + em * 0.95F}, color);
        }
        list.AddText({color != 0 ? left + em * 1.2F : left, y}, IM_COL32(240, 240, 240, 255), text.c_str());
        y += line;
    }
    list.PopClipRect();
}

void show_side_by_side(Session &session, const ViewPainter &painter, const Arrangement &arrangement) {
    for (const bool right : {false, true}) {
        const Rect rect = arrangement.column(right ? 1 : 0);
        draw_view(painter, right, rect);
        draw_mask_legend(session, painter, rect, right, false);
        draw_names(session, painter, rect, right, false);
    }
}

Rect left_half(const Rect &rect) { return {rect.low, {(rect.low.x + rect.high.x) / 2, rect.high.y}}; }
Rect right_half(const Rect &rect) { return {{(rect.low.x + rect.high.x) / 2, rect.low.y}, rect.high}; }

void show_wipe(Session &session, const ViewPainter &painter, const Rect &rect) {
    const float x = divider_x(session, rect);
    const float share = (x - rect.low.x) / rect.width();
    draw_view(painter, false, rect, 0, share);
    draw_view(painter, true, rect, share, 1);
    draw_mask_legend(session, painter, left_half(rect), false, false);
    draw_mask_legend(session, painter, right_half(rect), true, true);
    ImDrawList &list = *ImGui::GetWindowDrawList();
    const float middle = (rect.low.y + rect.high.y) / 2;
    const float grip = ImGui::GetFontSize() * 0.45F;
    list.AddRectFilled({x - 1.5F, rect.low.y}, {x + 1.5F, rect.high.y}, IM_COL32(255, 255, 255, 230));
    list.AddCircleFilled({x, middle}, grip + 2, IM_COL32(20, 24, 28, 255));
    list.AddCircleFilled({x, middle}, grip, IM_COL32(255, 255, 255, 255));
    describe_text(session, "View/divider", {x - grip, middle - grip}, {x + grip, middle + grip}, "");
    draw_names(session, painter, left_half(rect), false, false);
    draw_names(session, painter, right_half(rect), true, true);
}

void show_flip(Session &session, const ViewPainter &painter, const Rect &rect) {
    const bool right = session.view.show_right;
    draw_view(painter, right, rect);
    draw_mask_legend(session, painter, rect, right, false);
    draw_names(session, painter, rect, right, false);
    draw_text_line(session, "View/hint", rect, rect.low.y - ImGui::GetFrameHeight(), quiet_text(),
                   right ? "" : "hold Space for B", true);
}

void show_difference(Session &session, const ViewPainter &painter, const Rect &rect) {
    if (painter.difference_texture() != 0) {
        draw_picture_part(rect, painter.difference_texture(), 0, 1);
    } else {
        const std::string &error = painter.view(false).error;
        draw_error(rect, error.empty() ? painter.view(true).error : error, true);
    }
    draw_names(session, painter, left_half(rect), false, false, 1);
    draw_names(session, painter, right_half(rect), true, true, 1);
    if (painter.difference_texture() != 0) {
        difference_scale(session, painter, rect);
    }
}

} // namespace

void viewports(Session &session, ViewPainter &painter) {
    const Arrangement arrangement = arrange(session);
    for (int i = 0; i < arrangement.columns; ++i) {
        mouse_over_picture(session, arrangement.column(i), arrangement.columns == 1 ? "View" : i == 0 ? "A" : "B");
    }
    const Rect rect = arrangement.column(0);
    painter.paint(session, pixels_of(rect));
    session.triangles = painter.triangles(session.document.scene);
    session.same_picture = painter.same_picture(session.document);
    if (!ImGui::IsAnyItemActive()) {
        painter.measure_difference();
    }
    switch (session.view.layout) {
    case Layout::side_by_side:
        return show_side_by_side(session, painter, arrangement);
    case Layout::wipe:
        return show_wipe(session, painter, rect);
    case Layout::single:
        return show_flip(session, painter, rect);
    case Layout::difference:
        return show_difference(session, painter, rect);
    }
}

} // namespace sandbox

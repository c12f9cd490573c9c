#include "ui/frame.h"

#include "ui/keys.h"
#include "ui/menu_bar.h"
#include "ui/panels/side_panel.h"
#include "ui/views/viewports.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <algorithm>
#include <cmath>
#include <imgui.h>
#include <optional>

namespace sandbox {

namespace {

/// Without backgrounds: the frame is cleared to their colour already, and to fill them takes longer than all else in
/// it.
constexpr ImGuiWindowFlags fixed_window = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                          ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoSavedSettings |
                                          ImGuiWindowFlags_NoBringToFrontOnFocus;
constexpr ImGuiWindowFlags still_window =
    fixed_window | ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing;

bool begin_fixed(const char *name, ImVec2 position, ImVec2 size, ImGuiWindowFlags flags = fixed_window) {
    ImGui::SetNextWindowPos(position);
    ImGui::SetNextWindowSize(size);
    return ImGui::Begin(name, nullptr, flags);
}

constexpr float upright_share = 0.4F; ///< of an upright window's height: the side panel

/// Of the panel with its edge.
float side_width(const Session &session, const ImGuiViewport &window) {
    const float ems = session.appearance.sizes.side_ems;
    const float most = window.WorkSize.x * (ems > 0 ? 0.75F : 0.5F); // the pictures keep some room
    return std::floor(std::min(ImGui::GetFontSize() * (ems > 0 ? ems : 22), most));
}

/// An edge in a window of its own, which Ctrl+Tab reaches: where it is moved to.
std::optional<float> draw_edge(Session &session, const char *name, ImVec2 position, ImVec2 size, float &chosen,
                               const std::string &hint) {
    constexpr ImGuiWindowFlags flags =
        fixed_window | ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoFocusOnAppearing;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    const std::optional<float> moved =
        begin_fixed(name, position, size, flags) ? panel_edge(session, name, size, chosen, hint) : std::nullopt;
    ImGui::End();
    ImGui::PopStyleVar(2);
    return moved;
}

/// The only part that scrolls.
void draw_side(Session &session, ImVec2 position, ImVec2 size) {
    constexpr ImGuiWindowFlags scrolling =
        (fixed_window & ~ImGuiWindowFlags_NoScrollbar) | ImGuiWindowFlags_AlwaysVerticalScrollbar;
    if (ImGui::GetFrameCount() <= 1) {
        ImGui::SetNextWindowFocus(); // the arrow keys begin here
    }
    if (begin_fixed("Side panel", position, size, scrolling)) {
        side_panel(session);
    }
    ImGui::End();
}

/// Between the pictures and the panels.
void draw_edges(Session &session, ImVec2 origin, float side, ImVec2 room, float bottom) {
    PanelSizes &sizes = session.appearance.sizes;
    const float thickness = edge_thickness(), end = origin.y + room.y;
    if (const auto x = draw_edge(session, "side edge", {origin.x + side - thickness, origin.y}, {thickness, room.y},
                                 sizes.side_ems, session.text("edge.side.help"))) {
        sizes.side_ems = std::clamp(*x / ImGui::GetFontSize(), least_side_ems, most_side_ems);
    }
    if (!session.appearance.tab) {
        return;
    }
    if (const auto y = draw_edge(session, "bottom edge", {origin.x + side, end - bottom}, {room.x, thickness},
                                 sizes.bottom_share, session.text("edge.bottom.help"))) {
        sizes.bottom_share = std::clamp((end - *y) / room.y, least_bottom_share, most_bottom_share);
    }
}

/// Along the bottom of the area `room` at `corner`, `height` high.
void draw_bottom(Session &session, ViewPainter &painter, BottomPanel &panel, ImVec2 corner, ImVec2 room, float height) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    const bool open = begin_fixed("Tabs", {corner.x, corner.y + room.y - height}, {room.x, height});
    ImGui::PopStyleVar(2);
    if (open) {
        panel.draw(session, painter);
    }
    ImGui::End();
}

/// The hint about what the mouse is over or, without one, the last message.
void status_line(Session &session, float height) {
    StatusLine &status = session.status;
    if (status.message != session.message.text) {
        status = {session.message.text, session.message.text.empty() ? "" : session.hint};
    } else if (status.hidden_hint != session.hint) {
        status.hidden_hint.clear();
    }
    ImGui::SetCursorPosY((height - ImGui::GetTextLineHeight()) / 2);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const std::string message = session.message.text.empty() ? session.text("status.first") : session.message.text;
    describe_text(session, "Status", low,
                  {low.x + ImGui::GetContentRegionAvail().x, low.y + ImGui::GetTextLineHeight()}, message);
    if (!session.hint.empty() && session.hint != status.hidden_hint) {
        ImGui::TextColored(quiet_text(), "%s", session.hint.c_str());
    } else if (session.message.error) {
        ImGui::TextColored(error_text(), "%s", message.c_str());
    } else {
        ImGui::TextUnformatted(message.c_str());
    }
}

} // namespace

void draw_frame(Session &session, ViewPainter &painter, BottomPanel &bottom_panel) {
    session.hint.clear();
    const bool panels = session.appearance.panels;
    const ImGuiViewport &window = *ImGui::GetMainViewport(); // less the menu bar
    const float status = panels ? std::ceil(ImGui::GetFrameHeight()) : 0;
    const bool upright = is_upright(window.Size.x, window.Size.y, ImGui::GetFontSize());
    const float side = panels && !upright ? side_width(session, window) : 0;
    const ImVec2 origin{window.WorkPos.x, std::floor(window.WorkPos.y)}; // whole pixels, or gaps show between windows
    const float height = std::max(std::round(window.WorkPos.y + window.WorkSize.y) - origin.y - status, 32.0F);
    const float below = panels && upright ? std::floor(upright_share * height) : 0; // the side panel's
    const ImVec2 room{std::max(window.WorkSize.x - side, 32.0F), std::max(height - below, 32.0F)};
    const float bottom = panels ? BottomPanel::height(session, room.y) : 0;
    if (panels) {
        if (!upright) {
            draw_edges(session, origin, side, room, bottom); // first of all: Ctrl+Tab comes to them last
        }
        menu_bar(session);
        upright ? draw_side(session, {origin.x, origin.y + room.y}, {room.x, below})
                : draw_side(session, origin, {side - edge_thickness(), room.y});
    }
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    if (begin_fixed("views", {origin.x + side, origin.y}, {room.x, std::max(room.y - bottom, 32.0F)}, still_window)) {
        viewports(session, painter);
        if (ImGui::IsWindowFocused() && !ImGui::IsAnyItemActive()) {
            ImGui::SetWindowFocus("Side panel"); // pictures take the mouse, panels the arrow keys
        }
    }
    ImGui::End();
    ImGui::PopStyleVar();
    bottom_panel.follow(session, painter);
    if (panels) {
        const float edge = session.appearance.tab ? edge_thickness() : 0;
        draw_bottom(session, painter, bottom_panel, {origin.x + side, origin.y}, room, bottom - edge);
        ImGui::PushStyleColor(ImGuiCol_WindowBg, ImGui::GetStyleColorVec4(ImGuiCol_MenuBarBg));
        ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
        if (begin_fixed("status", {origin.x, origin.y + height}, {window.WorkSize.x, status},
                        still_window & ~ImGuiWindowFlags_NoBackground)) {
            status_line(session, status);
        }
        ImGui::End();
        ImGui::PopStyleVar();
        ImGui::PopStyleColor();
    }
    key_list(session);
    if (!ImGui::IsAnyItemActive()) {
        session.history.record(session.document); // a whole drag is one step
    }
}

} // namespace sandbox

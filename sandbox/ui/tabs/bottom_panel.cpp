#include "ui/tabs/bottom_panel.h"

#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <algorithm>
#include <cmath>
#include <imgui.h>

namespace sandbox {

namespace {

constexpr float least_share = 0.2F, most_share = 0.85F;

/// A half, more where that is little; never so much that the pictures are lost.
float first_share(float room) { return std::clamp(ImGui::GetFontSize() * 19 / room, 0.5F, 0.68F); }

float edge_height() { return std::max(4.0F, std::floor(ImGui::GetFontSize() * 0.3F)); }
float tabs_height() { return ImGui::GetFrameHeight() + 2 * ImGui::GetStyle().ItemSpacing.y; }

void draggable_edge(Session &session, float room) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 size{std::max(ImGui::GetContentRegionAvail().x, 1.0F), edge_height()};
    ImGui::InvisibleButton("edge", size);
    const bool active = ImGui::IsItemActive();
    if (active) {
        const float bottom = ImGui::GetWindowPos().y + ImGui::GetWindowHeight();
        session.appearance.bottom_share = std::clamp((bottom - ImGui::GetMousePos().y) / room, least_share, most_share);
    }
    if (active || ImGui::IsItemHovered()) {
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
        ImGui::GetWindowDrawList()->AddRectFilled(low, {low.x + size.x, low.y + size.y},
                                                  ImGui::GetColorU32(ImGuiCol_SliderGrab));
    }
    hint_for_item(session, "Drag: more or less room for the pictures.");
}

} // namespace

BottomPanel::BottomPanel(const DrawingSupplies &supplies) {
    tabs_.push_back({BottomTab::error_time, "Error vs run time",
                     "How far every technique is from the truth, and how long it takes (E).",
                     error_time_tab(supplies)});
    tabs_.push_back({BottomTab::glsl, "GLSL", "The programs of A and B beside each other (G).", glsl_tab(supplies)});
    tabs_.push_back({BottomTab::stability, "Stability",
                     "Stiff and extreme scenes, in which a textbook's formulas break (S).", stability_tab(supplies)});
}

float BottomPanel::height(const Session &session, float room) {
    const float tabs = tabs_height();
    const float chosen = session.appearance.bottom_share;
    const float share = chosen > 0 ? chosen : first_share(room);
    return session.appearance.tab ? std::max(std::floor(room * share), tabs) : tabs;
}

void BottomPanel::draw_tabs(Session &session) const {
    for (const Tab &tab : tabs_) {
        const bool open = session.appearance.tab == tab.tab;
        if (toggle_button(tab.title, open)) {
            toggle_tab(session, tab.tab);
        }
        hint_for_item(session, std::string(tab.hint) + (open ? "  Again: folds the panel." : ""));
        ImGui::SameLine(0, 2);
    }
    ImGui::NewLine();
}

void BottomPanel::draw(Session &session, ViewPainter &painter, const Fonts &fonts, float room) {
    const ImGuiStyle &style = ImGui::GetStyle();
    if (session.appearance.tab) {
        ImGui::SetCursorPos({0, 0});
        draggable_edge(session, room);
    }
    ImGui::SetCursorPos({style.WindowPadding.x, style.ItemSpacing.y + (session.appearance.tab ? edge_height() : 0)});
    draw_tabs(session);
    for (const Tab &tab : tabs_) {
        if (session.appearance.tab == tab.tab) {
            ImGui::SetCursorPosX(style.WindowPadding.x);
            if (ImGui::BeginChild(tab.title,
                                  {ImGui::GetContentRegionAvail().x - style.WindowPadding.x, -style.ItemSpacing.y})) {
                tab.content->draw(session, painter, fonts);
            }
            ImGui::EndChild();
        }
    }
}

News BottomPanel::take_news(Session &session) {
    News news = News::none;
    for (const Tab &tab : tabs_) {
        news = std::max(news, tab.content->take_news(session));
    }
    return news;
}

} // namespace sandbox

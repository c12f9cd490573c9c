#include "ui/tabs/bottom_panel.h"

#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>

namespace sandbox {

namespace {

/// Half of the height, or a little more if that is little: the pictures stay pictures.
float first_share(float room) { return std::clamp(ImGui::GetFontSize() * 19 / room, 0.5F, 0.55F); }

float tabs_height() { return std::ceil(ImGui::GetFrameHeight() + 2 * ImGui::GetStyle().ItemSpacing.y); }

void draggable_edge(Session &session, float room) {
    const ImVec2 size{std::max(ImGui::GetContentRegionAvail().x, 1.0F), edge_thickness()};
    float &share = session.appearance.sizes.bottom_share;
    if (panel_edge(session, "bottom edge", size, share, "Drag to give the pictures more or less room.")) {
        const float bottom = ImGui::GetWindowPos().y + ImGui::GetWindowHeight();
        share = std::clamp((bottom - ImGui::GetMousePos().y) / room, least_bottom_share, most_bottom_share);
    }
}

void draw_titles(Session &session) {
    for (std::size_t tab = 0; tab < std::size(bottom_tabs); ++tab) {
        const BottomTab &row = bottom_tabs[tab];
        const bool open = session.appearance.tab == tab;
        const char *fold = open ? "  Click again to fold it." : "";
        if (toggle_button(session, row.title, open, fmt::format("{} ({}).{}", row.hint, row.key, fold))) {
            toggle_tab(session, tab);
        }
        ImGui::SameLine(0, 2);
    }
    ImGui::NewLine();
}

} // namespace

BottomPanel::BottomPanel(const DrawingSupplies &supplies) {
    std::ranges::transform(bottom_tabs, contents_.begin(), [&](const BottomTab &row) { return row.make(supplies); });
}

float BottomPanel::height(const Session &session, float room) {
    const float tabs = tabs_height();
    const float chosen = session.appearance.sizes.bottom_share;
    const float share = chosen > 0 ? chosen : first_share(room);
    return session.appearance.tab ? std::max(std::floor(room * share), tabs) : tabs;
}

void BottomPanel::follow(Session &session, ViewPainter &painter) {
    const auto tab = session.appearance.tab;
    session.view.overlay = tab ? bottom_tabs[*tab].overlay : Overlay::none;
    if (tab) {
        contents_[*tab]->follow(session, painter);
    }
}

void BottomPanel::draw(Session &session, ViewPainter &painter, float room) {
    const ImGuiStyle &style = ImGui::GetStyle();
    if (session.appearance.tab) {
        ImGui::SetCursorPos({0, 0});
        draggable_edge(session, room);
    }
    ImGui::SetCursorPos({style.WindowPadding.x, style.ItemSpacing.y + (session.appearance.tab ? edge_thickness() : 0)});
    draw_titles(session);
    if (const auto tab = session.appearance.tab) {
        ImGui::SetCursorPosX(style.WindowPadding.x);
        const ImVec2 size{ImGui::GetContentRegionAvail().x - style.WindowPadding.x, -style.ItemSpacing.y};
        const ScopedName name(session, bottom_tabs[*tab].title);
        if (ImGui::BeginChild("content", size, false, ImGuiWindowFlags_NavFlattened)) {
            contents_[*tab]->draw(session, painter);
        }
        ImGui::EndChild();
    }
}

bool BottomPanel::busy() const {
    return std::ranges::any_of(contents_, [](const auto &content) { return content->busy(); });
}

News BottomPanel::take_news(Session &session) {
    News news = News::none;
    for (const auto &content : contents_) {
        news = std::max(news, content->take_news(session));
    }
    return news;
}

} // namespace sandbox

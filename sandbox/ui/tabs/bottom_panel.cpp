#include "ui/tabs/bottom_panel.h"

#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>
#include <optional>
#include <string>
#include <vector>

namespace sandbox {

namespace {

/// Half of the height, or a little more if that is little: the pictures stay pictures.
float first_share(float room) { return std::clamp(ImGui::GetFontSize() * 19 / room, 0.5F, 0.55F); }

constexpr float title_gap = 2; // pixels

float tabs_height() { return std::ceil(ImGui::GetFrameHeight() + 2 * ImGui::GetStyle().ItemSpacing.y); }

/// How the titles stand beside each other: the first way that fits.
enum class Titles { whole, brief, list };

Label title_of(const Session &session, const BottomTab &row, Titles titles) {
    Label title = session.label(title_key(row));
    if (titles == Titles::brief) {
        title.shown = session.text(title_key(row) + ".brief");
    }
    return title;
}

Titles titles_for(const Session &session, float room) {
    for (const Titles titles : {Titles::whole, Titles::brief}) {
        float width = 0;
        for (const BottomTab &row : bottom_tabs) {
            width += button_width(title_of(session, row, titles).shown) + title_gap;
        }
        if (width - title_gap <= room) {
            return titles;
        }
    }
    return Titles::list;
}

/// One list with all titles, and a way to fold the open one.
void draw_list(Session &session, float width) {
    std::vector<Label> names{session.label(session.appearance.tab ? "tabs.none" : "tabs.choose")};
    for (const BottomTab &row : bottom_tabs) {
        names.push_back(session.label(title_key(row)));
    }
    std::size_t chosen = session.appearance.tab ? *session.appearance.tab + 1 : 0;
    ImGui::SetNextItemWidth(std::min(width, ImGui::GetFontSize() * 14));
    if (combo(session, "tabs", names, chosen, session.text("tabs.help"))) {
        session.appearance.tab = chosen > 0 ? std::optional(chosen - 1) : std::nullopt;
    }
}

void draw_titles(Session &session) {
    const float room = ImGui::GetContentRegionAvail().x - ImGui::GetStyle().WindowPadding.x;
    const Titles titles = titles_for(session, room);
    if (titles == Titles::list) {
        return draw_list(session, room);
    }
    for (std::size_t tab = 0; tab < std::size(bottom_tabs); ++tab) {
        const BottomTab &row = bottom_tabs[tab];
        const bool open = session.appearance.tab == tab;
        const std::string help = session.text("hint.key", session.text(title_key(row) + ".help"), row.key);
        if (toggle_button(session, title_of(session, row, titles), open,
                          open ? help + "  " + session.text("tabs.fold") : help)) {
            toggle_tab(session, tab);
        }
        ImGui::SameLine(0, title_gap);
    }
    ImGui::NewLine();
}

constexpr float beside_ems = 45;      // the least width for two tabs beside each other
constexpr float lesson_share = 0.58F; // of that width

/// The tab that the lesson's step wants beside its own.
std::optional<std::size_t> tab_beside(const Session &session) {
    const auto &shown = session.document.step;
    if (!shown || session.appearance.tab != tab_made_by(lesson_tab)) {
        return std::nullopt;
    }
    for (std::size_t tab = 0; tab < std::size(bottom_tabs); ++tab) {
        if (shown->step().tab == std::string(1, bottom_tabs[tab].key) && tab != session.appearance.tab) {
            return tab;
        }
    }
    return std::nullopt;
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
    if (const auto beside = tab_beside(session)) {
        session.view.overlay = bottom_tabs[*beside].overlay;
        contents_[*beside]->follow(session, painter);
    }
}

void BottomPanel::draw_content(Session &session, ViewPainter &painter, std::size_t tab, float width) {
    const ScopedName name(session, session.label(title_key(bottom_tabs[tab])).name);
    const ImVec2 size{width, -ImGui::GetStyle().ItemSpacing.y};
    if (ImGui::BeginChild("content", size, false, ImGuiWindowFlags_NavFlattened)) {
        contents_[tab]->draw(session, painter);
    }
    ImGui::EndChild();
}

void BottomPanel::draw(Session &session, ViewPainter &painter) {
    const ImGuiStyle &style = ImGui::GetStyle();
    ImGui::SetCursorPos({style.WindowPadding.x, style.ItemSpacing.y});
    draw_titles(session);
    if (const auto tab = session.appearance.tab) {
        ImGui::SetCursorPosX(style.WindowPadding.x);
        const float width = ImGui::GetContentRegionAvail().x - style.WindowPadding.x;
        const auto beside = width > beside_ems * ImGui::GetFontSize() ? tab_beside(session) : std::nullopt;
        draw_content(session, painter, *tab, beside ? std::floor(width * lesson_share) : width);
        if (beside) {
            ImGui::SameLine(0, 2 * style.ItemSpacing.x);
            draw_content(session, painter, *beside, width - ImGui::GetItemRectSize().x - 2 * style.ItemSpacing.x);
        }
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

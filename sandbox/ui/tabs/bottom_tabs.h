#pragma once

#include "ui/jobs/drawing_job.h"
#include "ui/session/session.h"
#include "ui/views/view_painter.h"

#include <cstddef>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace sandbox {

/// The content of a tab of the bottom panel.
class TabContent {
  public:
    TabContent() = default;
    virtual ~TabContent() = default;
    TabContent(const TabContent &) = delete;
    TabContent &operator=(const TabContent &) = delete;

    /// In every frame while the tab is open, also while the panels are hidden: updates what it draws over the pictures.
    virtual void follow(Session &, ViewPainter &) {}
    /// Into the current ImGui window, while the tab is open; after follow().
    virtual void draw(Session &session, ViewPainter &painter) = 0;
    /// Called whenever the window wakes up, also while the tab is closed: is there something new to draw?
    virtual News take_news(Session &) { return News::none; }
    /// Does it work in the background?
    [[nodiscard]] virtual bool busy() const { return false; }
};

struct BottomTab {
    std::string_view word; ///< its title is the text tab.WORD, briefly tab.WORD.brief, and tab.WORD.help what it shows
    char key;              ///< opens and folds it
    std::unique_ptr<TabContent> (*make)(const DrawingSupplies &);
    Overlay overlay = Overlay::none; ///< drawn over the pictures while it is open
};
inline std::string title_key(const BottomTab &row) { return "tab." + std::string(row.word); }

std::unique_ptr<TabContent> pixel_probe_tab(const DrawingSupplies &supplies);
std::unique_ptr<TabContent> profile_tab(const DrawingSupplies &supplies);
std::unique_ptr<TabContent> motion_tab(const DrawingSupplies &supplies);
std::unique_ptr<TabContent> error_time_tab(const DrawingSupplies &supplies);
std::unique_ptr<TabContent> glsl_tab(const DrawingSupplies &supplies);
std::unique_ptr<TabContent> stability_tab(const DrawingSupplies &supplies);
std::unique_ptr<TabContent> lesson_tab(const DrawingSupplies &supplies);
std::unique_ptr<TabContent> exercise_tab(const DrawingSupplies &supplies);

/// From left to right. The panel, the menu, the keyboard and the list of keys read these rows.
constexpr BottomTab bottom_tabs[] = {
    {"pixel_probe", 'P', pixel_probe_tab, Overlay::pixel},
    {"profile", 'L', profile_tab, Overlay::profile},
    {"motion", 'O', motion_tab},
    {"error_time", 'E', error_time_tab},
    {"glsl", 'G', glsl_tab},
    {"stability", 'S', stability_tab},
    {"lesson", 'B', lesson_tab},
    {"exercise", 'H', exercise_tab},
};

/// The one that draws `overlay` over the pictures; none for Overlay::none.
constexpr std::optional<std::size_t> tab_of(Overlay overlay) {
    for (std::size_t tab = 0; tab < std::size(bottom_tabs); ++tab) {
        if (overlay != Overlay::none && bottom_tabs[tab].overlay == overlay) {
            return tab;
        }
    }
    return std::nullopt;
}

/// The one whose content this function makes.
constexpr std::size_t tab_made_by(decltype(BottomTab::make) make) {
    std::size_t tab = 0;
    while (bottom_tabs[tab].make != make) {
        ++tab;
    }
    return tab;
}

} // namespace sandbox

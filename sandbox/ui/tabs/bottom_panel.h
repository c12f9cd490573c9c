#pragma once

#include "ui/tabs/tab_content.h"

#include <vector>

namespace sandbox {

/// Below the pictures: a line of tabs, and the one that is open. Its upper edge can be dragged.
class BottomPanel {
  public:
    explicit BottomPanel(const DrawingSupplies &supplies);

    /// Of `room`, the height of pictures and panel together.
    [[nodiscard]] static float height(const Session &session, float room);
    /// In the current ImGui window, which has that height.
    void draw(Session &session, ViewPainter &painter, const Fonts &fonts, float room);
    /// The greatest of all tabs, shown or not.
    News take_news(Session &session);

  private:
    struct Tab {
        BottomTab tab;
        const char *title, *hint;
        std::unique_ptr<TabContent> content;
    };
    void draw_tabs(Session &session) const;

    std::vector<Tab> tabs_;
};

} // namespace sandbox

#pragma once

#include "ui/tabs/bottom_tabs.h"

#include <array>
#include <cstddef>

namespace sandbox {

/// Below the pictures: the titles of all tabs and the open one.
class BottomPanel {
  public:
    explicit BottomPanel(const DrawingSupplies &supplies);

    /// `room`: the height of pictures and panel together.
    [[nodiscard]] static float height(const Session &session, float room);
    /// What the open tab draws over the pictures, with or without the panel.
    void follow(Session &session, ViewPainter &painter);
    /// Fills the current ImGui window.
    void draw(Session &session, ViewPainter &painter);
    /// Does any tab work in the background?
    [[nodiscard]] bool busy() const;
    /// The most important news of any tab, shown or not.
    News take_news(Session &session);

  private:
    void draw_content(Session &session, ViewPainter &painter, std::size_t tab, float width);

    std::array<std::unique_ptr<TabContent>, std::size(bottom_tabs)> contents_;
};

} // namespace sandbox

#pragma once

#include "ui/jobs/drawing_job.h"
#include "ui/session/session.h"
#include "ui/views/view_painter.h"
#include "ui/widgets/fonts.h"

#include <memory>

namespace sandbox {

/// What stands in a tab of the bottom panel.
class TabContent {
  public:
    TabContent() = default;
    virtual ~TabContent() = default;
    TabContent(const TabContent &) = delete;
    TabContent &operator=(const TabContent &) = delete;

    /// In the current ImGui window; only while the tab is shown.
    virtual void draw(Session &session, ViewPainter &painter, const Fonts &fonts) = 0;
    /// Whenever the window wakes up, shown or not: what there is to draw.
    virtual News take_news(Session &) { return News::none; }
};

/// One a tab; bottom_panel.cpp lists them.
std::unique_ptr<TabContent> error_time_tab(const DrawingSupplies &supplies);
std::unique_ptr<TabContent> glsl_tab(const DrawingSupplies &supplies);
std::unique_ptr<TabContent> stability_tab(const DrawingSupplies &supplies);

} // namespace sandbox

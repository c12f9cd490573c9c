#include "ui/tab_content.h"

#include <imgui.h>

namespace sandbox {

namespace {

class ErrorTimeTab final : public TabContent {
  public:
    explicit ErrorTimeTab(const DrawingSupplies &supplies) : supplies_(supplies) {}
    void draw(Session &session, ViewPainter &painter, const Fonts &fonts) override;

  private:
    DrawingSupplies supplies_;
};

void ErrorTimeTab::draw(Session &, ViewPainter &, const Fonts &) {
    ImGui::TextUnformatted(supplies_.by.renderer.c_str());
}

} // namespace

std::unique_ptr<TabContent> error_time_tab(const DrawingSupplies &supplies) {
    return std::make_unique<ErrorTimeTab>(supplies);
}

} // namespace sandbox

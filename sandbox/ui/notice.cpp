#include "ui/notice.h"

#include <cmath>
#include <imgui.h>
#include <utility>

namespace sandbox {

namespace {

constexpr double seconds_shown = 4;

}

void Notice::say(std::string text, double now) {
    text_ = std::move(text);
    until_ = now + seconds_shown;
}

double Notice::seconds_left(double now) const { return shown() ? until_ - now : INFINITY; }

void Notice::draw() const {
    if (!shown()) {
        return;
    }
    const ImGuiViewport &window = *ImGui::GetMainViewport();
    const float em = ImGui::GetFontSize();
    const float wrap = window.WorkSize.x - 4 * em;
    const ImVec2 text = ImGui::CalcTextSize(text_.c_str(), nullptr, false, wrap);
    const ImVec2 at{std::floor(window.WorkPos.x + (window.WorkSize.x - text.x) / 2),
                    std::floor(window.WorkPos.y + em * 5.5F)}; // below the captions, on the pictures
    ImDrawList &list = *ImGui::GetForegroundDrawList();
    list.AddRectFilled({at.x - em, at.y - em * 0.6F}, {at.x + text.x + em, at.y + text.y + em * 0.6F},
                       IM_COL32(16, 18, 22, 235), em * 0.4F);
    list.AddText(ImGui::GetFont(), em, at, IM_COL32(255, 255, 255, 255), text_.c_str(), nullptr, wrap);
}

} // namespace sandbox

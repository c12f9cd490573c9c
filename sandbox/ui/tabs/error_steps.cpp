#include "ui/tabs/error_steps.h"

#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>

namespace sandbox {

namespace {

constexpr double lowest = 1e-3, highest = 1, one_level = 1.0 / 255;
constexpr std::size_t most_bars = 40;

float share_of(double error) {
    const double clamped = std::clamp(error, lowest, highest); // not finite: the whole height
    return static_cast<float>(std::log(clamped / lowest) / std::log(highest / lowest));
}

} // namespace

void error_steps(Session &session, const std::vector<double> &errors) {
    if (errors.empty()) {
        return;
    }
    const float em = ImGui::GetFontSize();
    const float height = em * 2.5F, step = em * 0.6F;
    const std::size_t first = errors.size() - std::min(errors.size(), most_bars);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = std::max(step * static_cast<float>(errors.size() - first), em * 6);
    ImDrawList &list = *ImGui::GetWindowDrawList();
    for (std::size_t i = first; i < errors.size(); ++i) {
        const float left = corner.x + step * static_cast<float>(i - first);
        const float top = corner.y + height - std::max(height * share_of(errors[i]), 2.0F);
        const bool last = i + 1 == errors.size();
        list.AddRectFilled({left, top}, {left + step - 2, corner.y + height},
                           ImGui::GetColorU32(last ? side_color(false) : quiet_text()));
    }
    const float level = corner.y + height - height * share_of(one_level);
    list.AddLine({corner.x, level}, {corner.x + width, level}, ImGui::GetColorU32(ImGuiCol_Text));
    ImGui::Dummy({width, height});
    ImGui::SameLine();
    const double now = errors.back();
    const std::string text = !std::isfinite(now) ? session.text("exercise_tab.not_finite")
                             : now == 0          ? session.text("exercise_tab.no_error")
                                                 : session.text("exercise_tab.error", fmt::format("{:.2g}", now));
    wrapped_text(quiet_text(), text);
    describe_item(session, "error", session.text("exercise_tab.error.help"), text);
}

} // namespace sandbox

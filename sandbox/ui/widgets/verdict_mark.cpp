#include "ui/widgets/verdict_mark.h"

#include "ui/widgets/theme.h"

#include <imgui.h>

namespace sandbox {

/// Drawn, for not every font has such letters.
void draw_mark(VerdictMark mark) {
    const float size = ImGui::GetTextLineHeight();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const auto at = [&](float x, float y) { return ImVec2{low.x + x * size, low.y + y * size}; };
    ImDrawList &list = *ImGui::GetWindowDrawList();
    const float thickness = size * 0.13F;
    if (mark == VerdictMark::tick) {
        const ImVec2 points[] = {at(0.08F, 0.55F), at(0.34F, 0.82F), at(0.82F, 0.2F)};
        list.AddPolyline(points, 3, ImGui::GetColorU32(side_color(true)), ImDrawFlags_None, thickness);
    } else if (mark == VerdictMark::cross) {
        const ImU32 color = ImGui::GetColorU32(error_text());
        list.AddLine(at(0.15F, 0.2F), at(0.75F, 0.8F), color, thickness);
        list.AddLine(at(0.75F, 0.2F), at(0.15F, 0.8F), color, thickness);
    } else if (mark == VerdictMark::dot) {
        list.AddCircleFilled(at(0.45F, 0.5F), size * 0.12F, ImGui::GetColorU32(quiet_text()));
    }
    ImGui::Dummy({size, size});
    ImGui::SameLine(0, size * 0.2F);
}

} // namespace sandbox

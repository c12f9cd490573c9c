#include "ui/tabs/error_time_view.h"
#include "ui/tabs/plot_drawing.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace sandbox {

namespace {

void legend_entry(Session &session, ErrorTimeView &view, std::size_t series) {
    const std::string name(name_of(all_frequencies[series]));
    const float em = ImGui::GetFontSize();
    const float sample = em * 1.9F;
    const ImVec2 size{sample + ImGui::CalcTextSize(name.c_str()).x + em * 0.3F, ImGui::GetFrameHeight()};
    if (series > 0) {
        same_line_if_fits(size.x);
    }
    const ImVec2 at = ImGui::GetCursorScreenPos();
    if (ImGui::InvisibleButton(name.c_str(), size)) {
        view.hidden[series] = !view.hidden[series];
    }
    const bool hidden = view.hidden[series];
    hint_for_item(session, hidden ? "Click to show this technique again." : "Click to hide this technique.");
    ImVec4 color = series_color(static_cast<int>(series));
    color.w = hidden ? 0.3F : 1;
    const ImU32 packed = ImGui::GetColorU32(color);
    ImDrawList &list = *ImGui::GetWindowDrawList();
    const float middle = at.y + size.y / 2;
    list.AddLine({at.x, middle}, {at.x + sample - em * 0.4F, middle}, packed, em * 0.12F);
    draw_marker(list, {at.x + (sample - em * 0.4F) / 2, middle}, em * 0.3F, static_cast<int>(series), packed);
    const bool lit = ImGui::IsItemHovered() || ImGui::IsItemFocused();
    list.AddText({at.x + sample, middle - em / 2},
                 ImGui::GetColorU32(hidden && !lit ? quiet_text() : ImGui::GetStyleColorVec4(ImGuiCol_Text)),
                 name.c_str());
    if (hidden) {
        list.AddLine({at.x + sample, middle}, {at.x + size.x, middle}, ImGui::GetColorU32(quiet_text()));
    }
}

/// Where there is room for it.
void front_entry() {
    const char *words = "no other is faster and closer";
    const float em = ImGui::GetFontSize();
    ImGui::SameLine();
    if (ImGui::GetContentRegionAvail().x < em * 2 + ImGui::CalcTextSize(words).x) {
        ImGui::NewLine();
        return;
    }
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float middle = at.y + ImGui::GetFrameHeight() / 2;
    ImGui::GetWindowDrawList()->AddLine({at.x, middle}, {at.x + em * 1.5F, middle}, ImGui::GetColorU32(front_color()),
                                        em * 0.4F);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + em * 1.9F);
    ImGui::AlignTextToFramePadding();
    ImGui::TextColored(quiet_text(), "%s", words);
}

} // namespace

void error_time_legend(Session &session, ErrorTimeView &view) {
    for (std::size_t series = 0; series < all_frequencies.size(); ++series) {
        legend_entry(session, view, series);
    }
    front_entry();
}

} // namespace sandbox

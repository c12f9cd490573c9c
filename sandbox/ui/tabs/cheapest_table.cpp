#include "ui/tabs/error_time_view.h"

#include "measure/report/text.h"
#include "ui/tabs/plot_drawing.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace sandbox {

namespace {

void technique_cell(Session &session, const WorkPrecision &measured, std::size_t row) {
    const PlannedRow &plan = measured.rows[row].plan;
    const float em = ImGui::GetFontSize();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const int style = series_style(plan.technique.frequency);
    draw_marker(*ImGui::GetWindowDrawList(), {at.x + em * 0.5F, at.y + em * 0.55F}, em * 0.3F, style,
                ImGui::GetColorU32(series_color(style)));
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + em * 1.2F);
    const std::string name =
        fmt::format("{}, {}", name_of(plan.technique.frequency), short_mesh_words(measured.meshes[plan.mesh]));
    ImGui::PushID(static_cast<int>(row));
    ImGui::Selectable(name.c_str(), false, ImGuiSelectableFlags_SpanAllColumns);
    ImGui::PopID();
    if (ImGui::IsItemHovered()) {
        row_clicks(session, measured, row);
    }
}

} // namespace

void cheapest_table(Session &session, const WorkPrecision &measured, const ErrorTimeView &view) {
    ImGui::TextColored(quiet_text(), "Cheapest with an error of at most");
    if (!ImGui::BeginTable("cheapest", 3, ImGuiTableFlags_SizingFixedFit)) {
        return;
    }
    for (const double bound : error_bounds) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(bound_name(bound).c_str());
        ImGui::TableNextColumn();
        ImGui::PushID(bound_name(bound).c_str());
        if (const auto row = cheapest(measured, view.model, view.norm, bound)) {
            ImGui::Text("%s ms", milliseconds_text(measured.rows[*row].time->median).c_str());
            ImGui::TableNextColumn();
            technique_cell(session, measured, *row);
        } else {
            ImGui::TableNextColumn();
            ImGui::TextColored(quiet_text(), "none of these");
        }
        ImGui::PopID();
    }
    ImGui::EndTable();
}

} // namespace sandbox

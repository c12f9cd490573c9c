#include "ui/jobs/measured_rows.h"
#include "ui/tabs/error_time_view.h"
#include "ui/tabs/plot_drawing.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <algorithm>

namespace sandbox {

namespace {

/// The plot without the series that are hidden; the front is that of what is left.
PlotRequest visible_plot(const WorkPrecision &measured, const ErrorTimeView &view) {
    PlotRequest plot = error_time_plot(measured, view.model, view.norm);
    std::erase_if(plot.series, [&](const PlotSeries &series) {
        return series.points.empty() || view.hidden[static_cast<std::size_t>(series.style)];
    });
    std::vector<TimeAndError> points;
    std::vector<std::size_t> tags;
    for (const PlotSeries &series : plot.series) {
        for (const PlotPoint &point : series.points) {
            points.push_back({point.x, point.y});
            tags.push_back(point.tag);
        }
    }
    plot.front.clear();
    for (const std::size_t point : pareto_front(points)) {
        plot.front.push_back(tags[point]);
    }
    return plot;
}

/// What keeps the numbers from being those of the scene that is shown; ends at `right`.
void warning(const WorkPrecision &measured, const Scene &shown, ImVec2 right) {
    std::string text = is_current(measured, shown) ? "" : "stale: not of the scene as it is now";
    if (!measured.finished) {
        text = "incomplete: cancelled" + (text.empty() ? "" : ";  " + text);
    }
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    ImGui::GetWindowDrawList()->AddText({right.x - width, right.y}, ImGui::GetColorU32(error_text()), text.c_str());
}

/// Above the mouse, towards the `middle` of the plot: neither its lower part nor the status line is hidden.
void tooltip(const WorkPrecision &measured, std::size_t row, float middle) {
    const ImVec2 mouse = ImGui::GetMousePos();
    const float gap = ImGui::GetFontSize();
    const bool to_left = mouse.x > middle;
    ImGui::SetNextWindowPos({mouse.x + (to_left ? -gap : gap), mouse.y - gap / 2}, ImGuiCond_Always,
                            {to_left ? 1.0F : 0.0F, 1.0F});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ImGui::GetFontSize() * 0.6F, ImGui::GetFontSize() * 0.4F));
    ImGui::BeginTooltip();
    ImVec4 color = series_color(series_style(measured.rows[row].plan.technique.frequency));
    for (const std::string &line : row_lines(measured, row)) {
        ImGui::TextColored(color, "%s", line.c_str());
        color = ImGui::GetStyleColorVec4(ImGuiCol_Text); // after the first, the technique
    }
    ImGui::EndTooltip();
    ImGui::PopStyleVar();
}

} // namespace

void row_clicks(Session &session, const WorkPrecision &measured, std::size_t row) {
    const bool current = is_current(measured, session.document.scene);
    session.hint = std::string(current ? "Click: this technique into A, its mesh into both.  "
                                       : "Click: this technique into A; the scene keeps its mesh.  ") +
                   "Right-click or Shift+click: into B.";
    const bool left = ImGui::IsMouseClicked(ImGuiMouseButton_Left);
    const bool right = ImGui::IsMouseClicked(ImGuiMouseButton_Right);
    if (left || right) {
        take_row(session.document, measured, row, right || ImGui::GetIO().KeyShift);
    }
}

void error_time_figure(Session &session, const WorkPrecision &measured, const ErrorTimeView &view, ImVec2 size) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton("plot", size, ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
    const bool over = ImGui::IsItemHovered();
    PlotRequest plot = visible_plot(measured, view);
    plot.width = static_cast<double>(size.x);
    plot.height = static_cast<double>(size.y);
    set_margins(plot);
    const PlotLayout layout = lay_out(plot);
    if (std::ranges::all_of(layout.series, [](const PlotSeries &series) { return series.points.empty(); })) {
        const char *why = plot.series.empty() ? "Nothing to plot: all of it is hidden, or nothing was timed."
                                              : "No error at all: every picture is exactly the truth.";
        ImGui::GetWindowDrawList()->AddText(corner, ImGui::GetColorU32(quiet_text()), why);
        return;
    }
    const ImVec2 mouse = ImGui::GetMousePos();
    const auto hovered = over ? nearest_point(layout, static_cast<double>(mouse.x - corner.x),
                                              static_cast<double>(mouse.y - corner.y), ImGui::GetFontSize() * 0.9)
                              : std::nullopt;
    draw_plot(plot, layout, corner, hovered);
    warning(measured, session.document.scene, {corner.x + static_cast<float>(layout.right), corner.y});
    for (const bool right : {false, true}) {
        if (const auto row = shown_row(measured, session.document, right)) {
            draw_ring(layout, corner, *row, right);
        }
    }
    if (hovered) {
        tooltip(measured, *hovered, corner.x + size.x / 2);
        row_clicks(session, measured, *hovered);
    }
}

} // namespace sandbox

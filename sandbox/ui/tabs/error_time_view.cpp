#include "ui/tabs/error_time_view.h"

#include "measure/report/text.h"
#include "ui/jobs/measured_rows.h"
#include "ui/tabs/plot_drawing.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"
#include "words/row_words.h"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <span>
#include <string>
#include <vector>

namespace sandbox {

namespace {

std::string title_of(const Words &words, Frequency frequency) {
    return title_of(words, frequency_key, static_cast<int>(frequency));
}
std::string title_of(const Words &words, Model model) { return title_of(words, model_key, static_cast<int>(model)); }
template <class Choice> Label label_of(const Session &session, Choice choice) {
    return {title_of(session.words, choice), title_of(session.words.english(), choice)};
}

/// Buttons beside each other; a list that opens if these would take too many lines (`narrow`).
template <typename Choice>
void choose(Session &session, const char *id, std::span<const Choice> choices, Choice &chosen, bool narrow,
            const std::string &hint) {
    std::vector<Label> names;
    std::ranges::transform(choices, std::back_inserter(names), [&](Choice c) { return label_of(session, c); });
    auto index = static_cast<std::size_t>(std::ranges::find(choices, chosen) - choices.begin());
    if (narrow) {
        float widest = 0;
        for (const Label &name : names) {
            widest = std::max(widest, ImGui::CalcTextSize(name.shown.c_str()).x);
        }
        ImGui::SetNextItemWidth(widest + ImGui::GetFrameHeight() * 1.5F);
        combo(session, id, names, index, hint);
    } else {
        for (std::size_t i = 0; i < names.size(); ++i) {
            if (i > 0) {
                ImGui::SameLine(0, 2);
            }
            index = toggle_button(session, names[i], i == index, hint) ? i : index;
        }
    }
    chosen = index < choices.size() ? choices[index] : chosen;
}

void legend_entry(Session &session, ErrorTimeView &view, std::size_t series) {
    const Label name = label_of(session, all_frequencies[series]);
    const float em = ImGui::GetFontSize();
    const float sample = em * 1.9F;
    const ImVec2 size{sample + ImGui::CalcTextSize(name.shown.c_str()).x + em * 0.3F, ImGui::GetFrameHeight()};
    if (series > 0) {
        same_line_if_fits(size.x);
    }
    const ImVec2 at = ImGui::GetCursorScreenPos();
    if (ImGui::InvisibleButton(name.name.c_str(), size)) {
        view.hidden[series] = !view.hidden[series];
    }
    const bool hidden = view.hidden[series];
    describe_item(session, name.name, session.text(hidden ? "error_time.show.help" : "error_time.hide.help"),
                  name.shown);
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
                 name.shown.c_str());
    if (hidden) {
        list.AddLine({at.x + sample, middle}, {at.x + size.x, middle}, ImGui::GetColorU32(quiet_text()));
    }
}

/// Where there is room for it.
void front_entry(const Session &session) {
    const std::string words = session.text("error_time.front");
    const float em = ImGui::GetFontSize();
    ImGui::SameLine();
    if (ImGui::GetContentRegionAvail().x < em * 2 + ImGui::CalcTextSize(words.c_str()).x) {
        ImGui::NewLine();
        return;
    }
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float middle = at.y + ImGui::GetFrameHeight() / 2;
    ImGui::GetWindowDrawList()->AddLine({at.x, middle}, {at.x + em * 1.5F, middle}, ImGui::GetColorU32(front_color()),
                                        em * 0.4F);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + em * 1.9F);
    ImGui::AlignTextToFramePadding();
    ImGui::TextColored(quiet_text(), "%s", words.c_str());
}

/// The plot without the series that are hidden; the front is that of what is left.
PlotRequest visible_plot(const Words &words, const WorkPrecision &measured, const ErrorTimeView &view) {
    PlotRequest plot = error_time_plot(words, measured, view.model, view.norm);
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
void warning(const Session &session, const WorkPrecision &measured, ImVec2 right) {
    std::vector<std::string> texts;
    if (!measured.finished) {
        texts.push_back(session.text("error_time.incomplete"));
    }
    if (!is_current(measured, session.document.scene)) {
        texts.push_back(session.text("error_time.stale"));
    }
    if (const std::size_t marked = marked_rows(measured); marked > 0) {
        texts.push_back(session.text("error_time.left_out", marked));
    }
    const std::string text = fmt::format("{}", fmt::join(texts, ";  "));
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    ImGui::GetWindowDrawList()->AddText({right.x - width, right.y}, ImGui::GetColorU32(error_text()), text.c_str());
}

/// Above the mouse, towards the `middle` of the plot: neither its lower part nor the status line is hidden.
void tooltip(const Session &session, const WorkPrecision &measured, std::size_t row, float middle) {
    const ImVec2 mouse = ImGui::GetMousePos();
    const float gap = ImGui::GetFontSize();
    const bool to_left = mouse.x > middle;
    ImGui::SetNextWindowPos({mouse.x + (to_left ? -gap : gap), mouse.y - gap / 2}, ImGuiCond_Always,
                            {to_left ? 1.0F : 0.0F, 1.0F});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ImGui::GetFontSize() * 0.6F, ImGui::GetFontSize() * 0.4F));
    ImGui::BeginTooltip();
    ImVec4 color = series_color(series_style(measured.rows[row].plan.technique.frequency));
    for (const std::string &line : row_lines(session.words, measured, row)) {
        ImGui::TextColored(color, "%s", line.c_str());
        color = ImGui::GetStyleColorVec4(ImGuiCol_Text); // after the first, the technique
    }
    ImGui::EndTooltip();
    ImGui::PopStyleVar();
}

/// After an item that stands for a row: takes the row if it is clicked; the hint says what a click does.
void row_clicks(Session &session, const WorkPrecision &measured, std::size_t row) {
    const bool current = is_current(measured, session.document.scene);
    session.hint = session.text(current ? "error_time.take.help" : "error_time.take_technique.help");
    const bool left = ImGui::IsMouseClicked(ImGuiMouseButton_Left);
    const bool right = ImGui::IsMouseClicked(ImGuiMouseButton_Right);
    if (left || right) {
        take_row(session.document, measured, row, right || ImGui::GetIO().KeyShift);
    }
}

void technique_cell(Session &session, const WorkPrecision &measured, std::size_t row) {
    const PlannedRow &plan = measured.rows[row].plan;
    const float em = ImGui::GetFontSize();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const int style = series_style(plan.technique.frequency);
    draw_marker(*ImGui::GetWindowDrawList(), {at.x + em * 0.5F, at.y + em * 0.55F}, em * 0.3F, style,
                ImGui::GetColorU32(series_color(style)));
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + em * 1.2F);
    const std::string name = session.text("technique.pair", title_of(session.words, plan.technique.frequency),
                                          short_mesh_words(session.words, measured.meshes[plan.mesh]));
    const ScopedId id(row);
    ImGui::Selectable(name.c_str(), false, ImGuiSelectableFlags_SpanAllColumns);
    if (ImGui::IsItemHovered()) {
        row_clicks(session, measured, row);
    }
}

} // namespace

void error_time_choices(Session &session, const WorkPrecision &measured, ErrorTimeView &view, bool narrow) {
    const std::vector<Model> models = models_of(measured);
    choose<Model>(session, "model", models, view.model, narrow, session.text("error_time.model.help"));
    ImGui::SameLine();
    choose<ErrorNorm>(session, "norm", error_norms, view.norm, narrow, session.text("error_time.norm.help"));
}

void error_time_legend(Session &session, ErrorTimeView &view) {
    for (std::size_t series = 0; series < all_frequencies.size(); ++series) {
        legend_entry(session, view, series);
    }
    front_entry(session);
}

void error_time_figure(Session &session, const WorkPrecision &measured, const ErrorTimeView &view, ImVec2 size) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton("plot", size, ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
    const bool over = ImGui::IsItemHovered();
    PlotRequest plot = visible_plot(session.words, measured, view);
    plot.width = static_cast<double>(size.x);
    plot.height = static_cast<double>(size.y);
    set_margins(plot);
    const PlotLayout layout = lay_out(plot);
    if (std::ranges::all_of(layout.series, [](const PlotSeries &series) { return series.points.empty(); })) {
        const std::string why = session.text(plot.series.empty() ? "error_time.nothing" : "error_time.no_error");
        ImGui::GetWindowDrawList()->AddText(corner, ImGui::GetColorU32(quiet_text()), why.c_str());
        return;
    }
    const ImVec2 mouse = ImGui::GetMousePos();
    const auto hovered = over ? nearest_point(layout, static_cast<double>(mouse.x - corner.x),
                                              static_cast<double>(mouse.y - corner.y), ImGui::GetFontSize() * 0.9)
                              : std::nullopt;
    draw_plot(plot, layout, corner, hovered);
    warning(session, measured, {corner.x + static_cast<float>(layout.right), corner.y});
    for (const bool right : {false, true}) {
        if (const auto row = shown_row(measured, session.document, right, view.model)) {
            const bool same = session.technique(right).model == view.model;
            const std::string name = right ? "B" : "A";
            const std::string text =
                same ? name : session.text("error_time.as", name, title_of(session.words, view.model));
            draw_ring(layout, corner, *row, right, text);
            describe_text(session, name, corner, {corner.x + size.x, corner.y + size.y}, text);
        }
    }
    if (hovered) {
        tooltip(session, measured, *hovered, corner.x + size.x / 2);
        row_clicks(session, measured, *hovered);
    }
}

void cheapest_table(Session &session, const WorkPrecision &measured, const ErrorTimeView &view) {
    ImGui::TextColored(quiet_text(), "%s", session.text("error_time.cheapest").c_str());
    if (!ImGui::BeginTable("cheapest", 3, ImGuiTableFlags_SizingFixedFit)) {
        return;
    }
    for (const double bound : error_bounds) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(bound_name(bound).c_str());
        ImGui::TableNextColumn();
        const ScopedId id(bound_name(bound));
        if (const auto row = cheapest(measured, view.model, view.norm, bound)) {
            ImGui::Text("%s ms", milliseconds_text(measured.rows[*row].time->median).c_str());
            ImGui::TableNextColumn();
            technique_cell(session, measured, *row);
            if (const auto ties = ties_of(measured, *row, view.norm, bound); !ties.empty()) {
                ImGui::TextColored(quiet_text(), "%s", session.text("error_time.tie").c_str());
                technique_cell(session, measured, ties.front());
                if (ties.size() > 1) {
                    ImGui::TextColored(quiet_text(), "%s", session.text("error_time.more", ties.size() - 1).c_str());
                }
            }
        } else {
            ImGui::TableNextColumn();
            ImGui::TextColored(quiet_text(), "%s", session.text("error_time.none").c_str());
        }
    }
    ImGui::EndTable();
}

} // namespace sandbox

#include "measure/report/figures.h"

#include "measure/report/html.h"
#include "measure/report/svg.h"
#include "measure/report/text.h"
#include "measure/report/work_precision_plot.h"
#include "words/row_words.h"

#include <algorithm>
#include <fmt/format.h>

namespace sandbox::html {
namespace {

std::string tip(const Words &words, const WorkPrecision &m, std::size_t i) {
    const MeasuredRow &row = m.rows[i];
    const Norms &error = row.errors->total.norms;
    return words.format("report.tip", to_string(row.plan.technique), mesh_words(words, m.meshes[row.plan.mesh]),
                        row.time ? words.format("report.tip_ms", milliseconds_text(row.time->median)) : "",
                        short_number(words, error.rmse), short_number(words, error.max_abs));
}

/// The error alone, rung by rung: the slope of a line is the order.
PlotRequest ladder_plot(const Words &words, const WorkPrecision &m, Model model) {
    PlotRequest plot;
    plot.title = words.format("report.rungs", title_of(words, model_key, static_cast<int>(model)));
    plot.x_label = words.text("report.column.rings");
    plot.width = 360;
    plot.height = 320;
    for (const PlannedMesh &mesh : m.meshes) {
        if (mesh.ladder) {
            plot.x_marks.push_back(mesh.rings);
        }
    }
    plot.y_label = long_title_of(words, ErrorNorm::rmse);
    for (const Frequency frequency : all_frequencies) {
        PlotSeries series{title_of(words, frequency_key, static_cast<int>(frequency)), series_style(frequency), {}};
        for (std::size_t i = 0; i < m.rows.size(); ++i) {
            const MeasuredRow &row = m.rows[i];
            const double rings = m.meshes[row.plan.mesh].rings;
            if (row.trusted() && row.plan.group == RowGroup::ladder && row.plan.technique.model == model &&
                row.plan.technique.frequency == frequency) {
                series.points.push_back({rings, row.errors->total.norms.rmse, rings, rings, i});
            }
        }
        plot.series.push_back(std::move(series));
    }
    plot.guides.push_back({1.0 / 510, words.text("plot.half_a_level")});
    return plot;
}

} // namespace

std::string ladder_plots(const ReportRun &run) {
    const WorkPrecision &m = run.measured;
    std::string body;
    for (const Model model : richest_first(m)) {
        body += fmt::format("<div>{}</div>\n", plot_svg(ladder_plot(run.words, m, model),
                                                        [&](std::size_t i) { return tip(run.words, m, i); }));
    }
    return legend_html(run.words, series_names(run.words), false) + "<div class=\"plots three\">" + body + "</div>\n";
}

std::string pictures(const ReportRun &run) {
    std::string body;
    for (const ReportPicture &picture : run.pictures) {
        body += figure(picture.title, picture.caption, picture.error, picture.image);
    }
    return section("pictures", run.words.text("report.pictures"), run.words.text("report.pictures.lead"),
                   body.empty() ? body : "<div class=\"figures\">" + body + "</div>\n");
}

std::string error_against_time(const ReportRun &run) {
    const WorkPrecision &m = run.measured;
    std::string body;
    for (const Model model : richest_first(m)) {
        for (const ErrorNorm norm : {ErrorNorm::rmse, ErrorNorm::max}) {
            const PlotRequest plot = error_time_plot(run.words, m, model, norm);
            const bool any =
                std::ranges::any_of(plot.series, [](const auto &series) { return !series.points.empty(); });
            body += any ? fmt::format("<div>{}</div>\n",
                                      plot_svg(plot, [&](std::size_t i) { return tip(run.words, m, i); }))
                        : "";
        }
    }
    return section("against", run.words.text("report.title"), run.words.text("report.against.lead"),
                   body.empty() ? body
                                : legend_html(run.words, series_names(run.words), true) + "<div class=\"plots\">" +
                                      body + "</div>\n");
}

std::string error_split(const ReportRun &run) {
    const WorkPrecision &m = run.measured;
    const auto models = models_of(m);
    std::vector<LabelledBar> bars;
    for (const Frequency frequency : all_frequencies) {
        bool first = true;
        for (const MeasuredRow &row : m.rows) {
            if (!row.trusted() || !is_base(row) || row.plan.technique.model != models.back() ||
                row.plan.technique.frequency != frequency) {
                continue;
            }
            Bar shares;
            std::vector<std::string> parts;
            for (const ErrorPart &part : error_parts) {
                shares.parts.push_back(part.rmse(row.errors->split));
                parts.push_back(
                    fmt::format("{} {}", title_of(run.words, part), short_number(run.words, shares.parts.back())));
            }
            bars.push_back(
                {run.words.format("technique.pair", title_of(run.words, frequency_key, static_cast<int>(frequency)),
                                  short_mesh_words(run.words, m.meshes[row.plan.mesh])),
                 "RMSE " + short_number(run.words, row.errors->total.norms.rmse),
                 fmt::format("{}", fmt::join(parts, run.words.text("list.comma"))), shares, first && !bars.empty()});
            first = false;
        }
    }
    if (bars.empty()) {
        return {};
    }
    std::string legend;
    for (const ErrorPart &part : error_parts) {
        legend += fmt::format(R"(<span><i class="p{}"></i>{}</span>)", &part - error_parts, title_of(run.words, part));
    }
    return section(
        "split", run.words.text("report.split"),
        run.words.format("report.split.lead", title_of(run.words, model_key, static_cast<int>(models.back()))),
        fmt::format("<p class=\"legend\">{}</p>\n<div class=\"bars\">{}</div>\n", legend,
                    bars_svg(bars, 1080, run.words.text("report.shares"))));
}

} // namespace sandbox::html

#include "measure/report/figures.h"

#include "measure/report/html.h"
#include "measure/report/svg.h"
#include "measure/report/text.h"
#include "measure/report/work_precision_plot.h"

#include <algorithm>
#include <fmt/format.h>

namespace sandbox::html {
namespace {

std::string tip(const Words &words, const WorkPrecision &m, std::size_t i) {
    const MeasuredRow &row = m.rows[i];
    const Norms &error = row.errors->total.norms;
    return fmt::format("{}, {}: {}RMSE {}, largest {}", to_string(row.plan.technique),
                       mesh_words(words, m.meshes[row.plan.mesh]),
                       row.time ? milliseconds_text(row.time->median) + " ms, " : "", short_number(error.rmse),
                       short_number(error.max_abs));
}

/// The error alone, rung by rung: the slope of a line is the order.
PlotRequest ladder_plot(const WorkPrecision &m, Model model) {
    PlotRequest plot;
    plot.title = fmt::format("{}: RMSE, rung by rung", name_of(model));
    plot.x_label = "rings";
    plot.width = 360;
    plot.height = 320;
    for (const PlannedMesh &mesh : m.meshes) {
        if (mesh.ladder) {
            plot.x_marks.push_back(mesh.rings);
        }
    }
    plot.y_label = "root mean square error";
    for (const Frequency frequency : all_frequencies) {
        PlotSeries series{std::string(name_of(frequency)), series_style(frequency), {}};
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
    plot.guides.push_back({1.0 / 510, "half a level"});
    return plot;
}

} // namespace

std::string ladder_plots(const ReportRun &run) {
    const WorkPrecision &m = run.measured;
    std::string body;
    for (const Model model : richest_first(m)) {
        body += fmt::format("<div>{}</div>\n",
                            plot_svg(ladder_plot(m, model), [&](std::size_t i) { return tip(run.words, m, i); }));
    }
    return legend_html(series_names(run.words), false) + "<div class=\"plots three\">" + body + "</div>\n";
}

std::string pictures(const ReportRun &run) {
    std::string body;
    for (const ReportPicture &picture : run.pictures) {
        body += figure(picture.title, picture.caption, picture.error, picture.image);
    }
    return section("pictures", "The pictures", "Linear colour in 8 bits, as <code>capture</code> writes it.",
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
    return section(
        "against", "Error against run time",
        "Down is closer to the truth, left is faster. A line follows one technique from coarse to fine "
        "meshes; its whiskers span the middle half of the times. Each model is judged against its own "
        "truth. Dashed: what a display of 8 or 10 bits resolves.",
        body.empty() ? body : legend_html(series_names(run.words), true) + "<div class=\"plots\">" + body + "</div>\n");
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
                parts.push_back(fmt::format("{} {}", part.name, short_number(shares.parts.back())));
            }
            bars.push_back(
                {fmt::format("{}, {}", name_of(frequency), short_mesh_words(run.words, m.meshes[row.plan.mesh])),
                 "RMSE " + short_number(row.errors->total.norms.rmse), fmt::format("{}", fmt::join(parts, ", ")),
                 shares, first && !bars.empty()});
            first = false;
        }
    }
    if (bars.empty()) {
        return {};
    }
    std::string legend;
    for (const ErrorPart &part : error_parts) {
        legend += fmt::format(R"(<span><i class="p{}"></i>{}</span>)", &part - error_parts, part.meaning);
    }
    return section(
        "split", "Where the error comes from",
        fmt::format("Shares of four root mean square errors under {}: the technique against per-pixel on the "
                    "same mesh (interpolation), that mesh against the truth's surface (geometry), float32 "
                    "against double (arithmetic), and rounding to 8 bits (quantisation). Beside each bar, "
                    "the error of the picture in float.",
                    name_of(models.back())),
        fmt::format("<p class=\"legend\">{}</p>\n<div class=\"bars\">{}</div>\n", legend,
                    bars_svg(bars, 1080, "Shares of the error")));
}

} // namespace sandbox::html

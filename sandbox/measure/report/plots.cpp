#include "measure/report/page.h"
#include "measure/report/svg.h"
#include "measure/report/text.h"
#include "measure/report/work_precision_plot.h"

#include "image/image_file.h"

#include <algorithm>

namespace sandbox::report_page {
namespace {

std::string tip(const WorkPrecision &m, std::size_t i) {
    const MeasuredRow &row = m.rows[i];
    return to_string(row.plan.technique) + ", " + mesh_words(m.meshes[row.plan.mesh]) + ": " +
           (row.time ? milliseconds_text(row.time->median) + " ms, RMSE " : "RMSE ") +
           short_number(row.errors->total.norms.rmse) + ", largest " + short_number(row.errors->total.norms.max_abs);
}

/// The error alone, rung by rung: the slope of a line is the order.
PlotRequest ladder_plot(const WorkPrecision &m, Model model) {
    PlotRequest plot;
    plot.title = std::string(name_of(model)) + ": RMSE, rung by rung";
    plot.x_label = "rings";
    plot.width = 360;
    plot.height = 320;
    for (const PlannedMesh &mesh : m.meshes) {
        if (mesh.ladder) {
            plot.x_marks.push_back(mesh.rings);
        }
    }
    plot.y_label = "root mean square error";
    for (std::size_t f = 0; f < std::size(plotted_frequencies); ++f) {
        PlotSeries series{std::string(name_of(plotted_frequencies[f])), static_cast<int>(f), {}};
        for (std::size_t i = 0; i < m.rows.size(); ++i) {
            const MeasuredRow &row = m.rows[i];
            const double rings = m.meshes[row.plan.mesh].rings;
            if (row.finite() && row.plan.group == RowGroup::ladder && row.plan.technique.model == model &&
                row.plan.technique.frequency == plotted_frequencies[f]) {
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
    auto models = models_of(m);
    std::ranges::reverse(models);
    for (const Model model : models) {
        body += "<div>" + plot_svg(ladder_plot(m, model), [&](std::size_t i) { return tip(m, i); }) + "</div>\n";
    }
    return legend_html(plotted_names(), false) + "<div class=\"plots three\">" + body + "</div>\n";
}

std::string pictures(const ReportRun &run) {
    if (run.pictures.empty()) {
        return {};
    }
    std::string body = "<div class=\"figures\">";
    for (const ReportPicture &picture : run.pictures) {
        body += "<figure><img alt=\"" + escaped(picture.title + ": " + picture.caption) +
                "\" src=\"data:image/png;base64," + base64(encode_png(picture.image)) + "\"><figcaption><b>" +
                escaped(picture.title) + "</b>" + escaped(picture.caption) + "</figcaption></figure>\n";
    }
    return section("pictures", "The pictures", "Linear colour in 8 bits, as <code>capture</code> writes it.",
                   body + "</div>\n");
}

std::string error_against_time(const ReportRun &run) {
    const WorkPrecision &m = run.measured;
    std::string body;
    auto models = models_of(m);
    std::ranges::reverse(models);
    for (const Model model : models) {
        for (const ErrorNorm norm : {ErrorNorm::rmse, ErrorNorm::max}) {
            const PlotRequest plot = error_time_plot(m, model, norm);
            const bool any =
                std::ranges::any_of(plot.series, [](const auto &series) { return !series.points.empty(); });
            body += any ? "<div>" + plot_svg(plot, [&](std::size_t i) { return tip(m, i); }) + "</div>\n" : "";
        }
    }
    return section("against", "Error against run time",
                   "Down is closer to the truth, left is faster. A line follows one technique from coarse to fine "
                   "meshes; its whiskers span the middle half of the times. Each model is judged against its own "
                   "truth. Dashed: what a display of 8 or 10 bits resolves.",
                   body.empty() ? body
                                : legend_html(plotted_names(), true) + "<div class=\"plots\">" + body + "</div>\n");
}

std::string error_split(const ReportRun &run) {
    const WorkPrecision &m = run.measured;
    const auto models = models_of(m);
    std::vector<LabelledBar> bars;
    for (const Frequency frequency : plotted_frequencies) {
        bool first = true;
        for (const MeasuredRow &row : m.rows) {
            if (!row.finite() || !is_base(row) || row.plan.technique.model != models.back() ||
                row.plan.technique.frequency != frequency) {
                continue;
            }
            const ErrorSplit &split = row.errors->split;
            const double geometry = split.geometry ? split.geometry->rmse : 0;
            const PlannedMesh &mesh = m.meshes[row.plan.mesh];
            bars.push_back({std::string(name_of(frequency)) + ", " +
                                (mesh.ladder ? std::to_string(mesh.rings) + " rings" : "own mesh"),
                            "RMSE " + short_number(row.errors->total.norms.rmse),
                            "interpolation " + short_number(split.interpolation.rmse) + ", geometry " +
                                short_number(geometry) + ", arithmetic " + short_number(split.arithmetic.rmse) +
                                ", quantisation " + short_number(split.quantisation.rmse),
                            {{split.interpolation.rmse, geometry, split.arithmetic.rmse, split.quantisation.rmse}},
                            first && !bars.empty()});
            first = false;
        }
    }
    if (bars.empty()) {
        return {};
    }
    const std::string legend = "<p class=\"legend\"><span><i class=\"p0\"></i>interpolation</span><span><i "
                               "class=\"p1\"></i>geometry</span><span><i class=\"p2\"></i>float32 arithmetic</span>"
                               "<span><i class=\"p3\"></i>8-bit quantisation</span></p>\n";
    return section("split", "Where the error comes from",
                   "Shares of four root mean square errors under " + std::string(name_of(models.back())) +
                       ": the technique against per-pixel on the same mesh (interpolation), that mesh against the "
                       "truth's surface (geometry), float32 against double (arithmetic), and rounding to 8 bits "
                       "(quantisation). Beside each bar, the error of the picture in float.",
                   legend + "<div class=\"bars\">" + bars_svg(bars, 1080, "Shares of the error") + "</div>\n");
}

} // namespace sandbox::report_page

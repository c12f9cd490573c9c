#include "measure/report/figure_plots.h"

#include "measure/report/paper.h"
#include "measure/report/text.h"
#include "measure/work_precision/findings.h"
#include "words/row_words.h"

#include <cmath>
#include <fmt/format.h>

namespace sandbox {

PlotRequest profile_plot(const Words &words, int row, const std::vector<NamedCurve> &curves) {
    PlotRequest plot;
    plot.title = words.format("figures.profile.title", row);
    plot.x_label = words.text("figures.column");
    plot.y_label = words.text("figures.luminance");
    plot.x_scale = plot.y_scale = Scale::linear;
    plot.width = 720;
    plot.x_room = 0;
    plot.y_shown = {0, 0.05}; // black has a place, and rounding in the dark is not magnified
    for (const NamedCurve &curve : curves) {
        PlotSeries series{curve.name, curve.style, {}, true, curve.width};
        for (std::size_t i = 0; i < curve.luminance.size(); ++i) {
            const double x = static_cast<double>(i) + 0.5;
            series.points.push_back({x, curve.luminance[i], x, x, i});
        }
        plot.series.push_back(std::move(series));
    }
    return plot;
}

std::optional<double> last_order(const WorkPrecision &measured) {
    const std::vector<OrderStep> steps = convergence_orders(measured);
    return steps.empty() ? std::nullopt : steps.back().total.l2;
}

PlotRequest subdivision_plot(const Words &words, const WorkPrecision &measured) {
    PlotRequest plot;
    plot.title = words.format("figures.subdivision.title", title_of(words, measured.options.only.front()));
    plot.x_label = words.text("figures.triangles");
    plot.y_label = words.text("figures.error");
    const auto order = last_order(measured);
    for (const ErrorNorm norm : {ErrorNorm::max, ErrorNorm::rmse}) {
        std::string name = norm == ErrorNorm::max ? long_title_of(words, norm) : title_of(words, norm);
        name += norm == ErrorNorm::rmse && order ? words.format("figures.order_note", *order) : "";
        PlotSeries series{name, norm == ErrorNorm::max ? style_a : style_b, {}};
        for (std::size_t i = 0; i < measured.rows.size(); ++i) {
            const MeasuredRow &row = measured.rows[i];
            if (row.trusted() && row.plan.group == RowGroup::ladder) {
                const auto x = static_cast<double>(measured.meshes[row.plan.mesh].triangles);
                series.points.push_back({x, value_of(row.errors->total.norms, norm), x, x, i});
            }
        }
        plot.series.push_back(std::move(series));
    }
    if (const auto &rmse = plot.series.back().points; rmse.size() > 1 && rmse.front().y > 0) {
        PlotSeries slope{words.text("figures.order_two"), style_guide, {rmse.front()}, true};
        const double finer = rmse.back().x / rmse.front().x; // triangles halve in width where their number is fourfold
        slope.points.push_back({rmse.back().x, rmse.front().y / finer, rmse.back().x, rmse.back().x, 0});
        plot.series.push_back(std::move(slope));
    }
    plot.guides.push_back({1.0 / 510, words.text("plot.half_a_level")});
    return plot;
}

} // namespace sandbox

#include "measure/report/work_precision_plot.h"

#include "measure/report/text.h"

#include <algorithm>

namespace sandbox {

namespace {

std::string_view words_of(ErrorNorm norm) {
    return norm == ErrorNorm::rmse  ? "root mean square error"
           : norm == ErrorNorm::p99 ? "99th percentile of the error"
                                    : "largest error";
}

PlotSeries series_of(const WorkPrecision &m, Technique technique, int style, ErrorNorm norm) {
    PlotSeries series{std::string(name_of(technique.frequency)), style, {}};
    for (std::size_t i = 0; i < m.rows.size(); ++i) {
        const MeasuredRow &row = m.rows[i];
        if (row.complete() && row.finite() && row.plan.technique == technique) {
            series.points.push_back({row.time->median, value_of(row.errors->total.norms, norm),
                                     row.time->lower_quartile, row.time->upper_quartile, i});
        }
    }
    std::ranges::stable_sort(series.points, {},
                             [&](const PlotPoint &point) { return m.meshes[m.rows[point.tag].plan.mesh].triangles; });
    return series;
}

} // namespace

std::vector<std::string> plotted_names() {
    std::vector<std::string> names;
    for (const Frequency frequency : plotted_frequencies) {
        names.emplace_back(name_of(frequency));
    }
    return names;
}

int series_style(Frequency frequency) {
    return static_cast<int>(std::ranges::find(plotted_frequencies, frequency) - plotted_frequencies);
}

PlotRequest error_time_plot(const WorkPrecision &m, Model model, ErrorNorm norm) {
    PlotRequest plot;
    plot.title =
        std::string(name_of(model)) + ": " + (norm == ErrorNorm::max ? "largest error" : std::string(name_of(norm)));
    plot.x_label = "median time of a frame, ms";
    plot.y_label = words_of(norm);
    for (std::size_t f = 0; f < std::size(plotted_frequencies); ++f) {
        Technique base; // every key at its default
        base.frequency = plotted_frequencies[f];
        base.model = model;
        plot.series.push_back(series_of(m, base, static_cast<int>(f), norm));
    }
    plot.front = pareto_front(m, model, norm);
    for (const double bound : error_bounds) {
        plot.guides.push_back({bound, bound_name(bound)});
    }
    plot.guides.push_back({1.0 / 510, "half a level"});
    return plot;
}

} // namespace sandbox

#include "measure/report/work_precision_plot.h"

#include "measure/report/text.h"

#include <algorithm>
#include <fmt/format.h>

namespace sandbox {

namespace {

PlotSeries series_of(const WorkPrecision &m, const Technique &technique, ErrorNorm norm) {
    PlotSeries series{std::string(name_of(technique.frequency)), series_style(technique.frequency), {}};
    for (std::size_t i = 0; i < m.rows.size(); ++i) {
        const MeasuredRow &row = m.rows[i];
        if (row.complete() && row.trusted() && row.plan.technique == technique) {
            series.points.push_back({row.time->median, value_of(row.errors->total.norms, norm),
                                     row.time->lower_quartile, row.time->upper_quartile, i});
        }
    }
    std::ranges::stable_sort(series.points, {},
                             [&](const PlotPoint &point) { return m.meshes[m.rows[point.tag].plan.mesh].triangles; });
    return series;
}

} // namespace

std::vector<std::string> series_names() {
    std::vector<std::string> names;
    names.reserve(all_frequencies.size());
    for (const Frequency frequency : all_frequencies) {
        names.emplace_back(name_of(frequency));
    }
    return names;
}

PlotRequest error_time_plot(const WorkPrecision &m, Model model, ErrorNorm norm) {
    PlotRequest plot;
    plot.title = fmt::format("{}: {}", name_of(model), norm == ErrorNorm::max ? "largest error" : name_of(norm));
    plot.x_label = "median time of a frame, ms";
    plot.y_label = quantity_of(norm).meaning;
    for (const Frequency frequency : all_frequencies) {
        plot.series.push_back(series_of(m, {.frequency = frequency, .model = model}, norm)); // every key at its default
    }
    plot.front = pareto_front(m, model, norm);
    for (const double bound : error_bounds) {
        plot.guides.push_back({bound, bound_name(bound)});
    }
    plot.guides.push_back({1.0 / 510, "half a level"});
    return plot;
}

} // namespace sandbox

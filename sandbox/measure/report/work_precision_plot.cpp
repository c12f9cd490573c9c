#include "measure/report/work_precision_plot.h"

#include "measure/report/text.h"
#include "words/row_words.h"

#include <algorithm>
#include <fmt/format.h>

namespace sandbox {

namespace {

static_assert(all_frequencies.size() == 6, "style.css, theme.cpp, paper.h and marker_corners() have a style for each");

PlotSeries series_of(const Words &words, const WorkPrecision &m, const Technique &technique, ErrorNorm norm) {
    PlotSeries series{
        title_of(words, frequency_key, static_cast<int>(technique.frequency)), series_style(technique.frequency), {}};
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

std::vector<std::string> series_names(const Words &words) {
    std::vector<std::string> names;
    names.reserve(all_frequencies.size());
    for (const Frequency frequency : all_frequencies) {
        names.push_back(title_of(words, frequency_key, static_cast<int>(frequency)));
    }
    return names;
}

PlotRequest error_time_plot(const Words &words, const WorkPrecision &m, Model model, ErrorNorm norm) {
    PlotRequest plot;
    plot.title = words.format("plot.title", title_of(words, model_key, static_cast<int>(model)),
                              norm == ErrorNorm::max ? long_title_of(words, norm) : title_of(words, norm));
    plot.x_label = words.text("plot.time");
    plot.y_label = long_title_of(words, norm);
    for (const Frequency frequency : all_frequencies) {
        plot.series.push_back(
            series_of(words, m, {.frequency = frequency, .model = model}, norm)); // every key at its default
    }
    plot.front = pareto_front(m, model, norm);
    plot.front_name = words.text("report.front");
    for (const double bound : error_bounds) {
        plot.guides.push_back({bound, bound_name(bound)});
    }
    plot.guides.push_back({1.0 / 510, words.text("plot.half_a_level")});
    return plot;
}

} // namespace sandbox

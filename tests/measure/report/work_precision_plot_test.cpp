#include "measure/report/work_precision_plot.h"
#include "tools/english.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace sandbox {
namespace {

MeasuredRow row_of(std::size_t mesh, Frequency frequency, double error, double ms) {
    MeasuredRow row;
    row.plan.mesh = mesh;
    row.plan.technique.frequency = frequency;
    row.plan.technique.model = Model::phong;
    row.errors = RowErrors{};
    row.errors->total.norms.rmse = error;
    row.errors->total.norms.p99_abs = 2 * error;
    row.errors->total.norms.max_abs = 3 * error;
    row.time = run_time({ms, ms, ms});
    return row;
}

WorkPrecision measured() {
    WorkPrecision m;
    m.meshes = {{8, false, true, 100, {}}, {16, false, true, 400, {}}};
    m.rows = {row_of(1, Frequency::per_vertex, 0.01, 2), row_of(0, Frequency::per_vertex, 0.04, 1),
              row_of(0, Frequency::per_pixel, 0.02, 3)};
    return m;
}

const PlotSeries &series(const PlotRequest &plot, Frequency frequency) {
    return plot.series[static_cast<std::size_t>(series_style(frequency))];
}

TEST(ErrorTimePlot, OneLineAFrequencyFromCoarseToFine) {
    const PlotRequest plot = error_time_plot(english, measured(), Model::phong, ErrorNorm::rmse);
    ASSERT_EQ(plot.series.size(), all_frequencies.size());
    const auto &points = series(plot, Frequency::per_vertex).points;
    ASSERT_EQ(points.size(), 2U);
    EXPECT_EQ(points[0].tag, 1U) << "the coarser mesh";
    EXPECT_EQ(points[0].x, 1);
    EXPECT_EQ(points[0].y, 0.04);
    EXPECT_EQ(points[1].tag, 0U);
    EXPECT_TRUE(series(plot, Frequency::flat).points.empty());
    EXPECT_EQ(plot.front, (std::vector<std::size_t>{1, 0})) << "per-pixel is slower and no closer";
}

TEST(ErrorTimePlot, TheNormIsTheOneAskedFor) {
    EXPECT_EQ(
        series(error_time_plot(english, measured(), Model::phong, ErrorNorm::p99), Frequency::per_pixel).points[0].y,
        0.04);
    EXPECT_EQ(
        series(error_time_plot(english, measured(), Model::phong, ErrorNorm::max), Frequency::per_pixel).points[0].y,
        0.06);
}

TEST(ErrorTimePlot, LeavesOutVariantsOtherModelsAndWhatHasNoNumbers) {
    WorkPrecision m = measured();
    m.rows[0].plan.technique.program = Program::full;
    m.rows[1].plan.technique.model = Model::lambert;
    m.rows[2].time.reset();
    m.rows.push_back(row_of(0, Frequency::hybrid, 0.02, 3));
    m.rows.back().errors->total.nonfinite_pixels = 1;
    m.rows.push_back(row_of(0, Frequency::flat, 0.02, 3));
    m.rows.back().errors->total.compared_share = 0.49; // too little of its picture
    for (const PlotSeries &one : error_time_plot(english, m, Model::phong, ErrorNorm::rmse).series) {
        EXPECT_TRUE(one.points.empty()) << one.name;
    }
}

TEST(ErrorTimePlot, GuidesAreTheTolerances) {
    const PlotRequest plot = error_time_plot(english, measured(), Model::phong, ErrorNorm::rmse);
    for (const double bound : error_bounds) {
        EXPECT_NE(std::ranges::find(plot.guides, bound, &PlotGuide::y), plot.guides.end()) << bound;
    }
}

} // namespace
} // namespace sandbox

#include "measure/report/figure_plots.h"

#include "measure/report/paper.h"
#include "measure/report/svg.h"
#include "tools/english.h"
#include "tools/xml.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <stdexcept>
#include <string>

namespace sandbox {
namespace {

/// Triangles fourfold, RMSE a quarter, the largest error half: orders 2 and 1.
WorkPrecision series_of_rungs() {
    WorkPrecision m;
    m.options.only = {{.frequency = Frequency::per_vertex, .model = Model::phong}};
    for (int rung = 0; rung < 3; ++rung) {
        const auto finer = static_cast<double>(1 << (2 * rung));
        m.meshes.push_back({8 << rung, false, true, static_cast<std::size_t>(100 * finer), {}});
        MeasuredRow row;
        row.plan = {static_cast<std::size_t>(rung), m.options.only.front(), RowGroup::ladder};
        row.errors = RowErrors{};
        row.errors->total.norms.rmse = 0.04 / finer;
        row.errors->total.norms.max_abs = 0.4 / (1 << rung);
        row.errors->total.compared_pixels = 100;
        row.errors->total.compared_share = 1;
        m.rows.push_back(row);
    }
    return m;
}

TEST(SubdivisionPlot, HasTheErrorsOverTheTrianglesAndTheSlopeOfOrderTwo) {
    const WorkPrecision measured = series_of_rungs();
    EXPECT_NEAR(last_order(measured).value_or(0), 2, 1e-12);
    const PlotRequest plot = subdivision_plot(english, measured);
    ASSERT_EQ(plot.series.size(), 3U);
    EXPECT_EQ(plot.series[0].name, "largest error");
    EXPECT_EQ(plot.series[1].name, "RMSE, order 2.00 in the last step");
    ASSERT_EQ(plot.series[1].points.size(), 3U);
    EXPECT_EQ(plot.series[1].points[2].x, 1600);
    EXPECT_EQ(plot.series[0].points[2].y, 0.1);
    const PlotSeries &slope = plot.series[2];
    EXPECT_EQ(slope.points.front().y, plot.series[1].points.front().y);
    EXPECT_NEAR(slope.points.back().y, plot.series[1].points.back().y, 1e-12) << "the RMSE is of order 2";
}

TEST(SubdivisionPlot, LeavesOutRungsThatSayTooLittle) {
    WorkPrecision measured = series_of_rungs();
    measured.rows[1].errors->total.compared_share = 0.1;
    measured.rows[1].errors->total.edge_pixels = 900;
    EXPECT_EQ(subdivision_plot(english, measured).series[0].points.size(), 2U);
}

PlotRequest two_curves() {
    return profile_plot(english, 7, {{"the <truth>", style_truth, {0, 0.5, 1}, 6}, {"A & B", style_a, {0, 0.25, 1}}});
}

TEST(ProfilePlot, HasEveryPixelAtItsMiddle) {
    const PlotRequest plot = two_curves();
    ASSERT_EQ(plot.series[1].points.size(), 3U);
    EXPECT_EQ(plot.series[1].points[1].x, 1.5);
    EXPECT_EQ(plot.series[1].points[1].y, 0.25);
    const PlotLayout layout = lay_out(plot);
    EXPECT_NEAR(layout.series[0].points.front().x, layout.left, 1e-6) << "as wide as the picture";
    EXPECT_NEAR(layout.series[0].points.back().x, layout.right, 1e-6);
}

TEST(ProfilePlot, ShowsBlackAndDoesNotMagnifyTheDark) {
    for (const double level : {0.0, 1e-9, 0.8}) {
        const PlotLayout layout = lay_out(profile_plot(english, 7, {{"A", style_a, {level, level}}}));
        ASSERT_FALSE(layout.y_ticks.empty());
        EXPECT_EQ(layout.y_ticks.front().label, "0");
        EXPECT_GE(std::stod(layout.y_ticks[1].label), 0.01);
    }
}

TEST(PlotFile, IsWellFormedAndNeedsNoStyleFromElsewhere) {
    for (const std::string &svg : {plot_file(two_curves()), plot_file(subdivision_plot(english, series_of_rungs()))}) {
        EXPECT_TRUE(well_formed(svg)) << svg;
        EXPECT_EQ(svg.find("var("), std::string::npos) << "not every program knows variables";
        EXPECT_NE(svg.find("xmlns=\"http://www.w3.org/2000/svg\""), std::string::npos);
    }
    EXPECT_FALSE(well_formed("<svg><g></svg>"));
    EXPECT_FALSE(well_formed("<svg a=b></svg>"));
    EXPECT_FALSE(well_formed("<svg>A & B</svg>"));
    EXPECT_FALSE(well_formed("<svg></svg><svg></svg>"));
    EXPECT_FALSE(well_formed(""));
}

TEST(PlotFile, NamesItsSeriesAndDrawsCurvesWithoutMarkers) {
    const std::string svg = plot_file(two_curves());
    EXPECT_NE(svg.find("the &lt;truth&gt;"), std::string::npos);
    EXPECT_NE(svg.find("A &amp; B"), std::string::npos);
    EXPECT_EQ(svg.find("class=\"dot\""), std::string::npos);
    EXPECT_NE(plot_file(subdivision_plot(english, series_of_rungs())).find("class=\"dot\""), std::string::npos);
}

TEST(PlotFile, TheLegendIsBelowTheFrameAndWithinIts) {
    PlotRequest plot = two_curves();
    for (int i = 0; i < 5; ++i) {
        plot.series.push_back({"per pixel, Lambert; normals: model matrix (wrong)", style_b, plot.series[0].points});
    }
    const PlotRequest whole = with_legend(plot);
    const PlotLayout layout = lay_out(whole);
    EXPECT_EQ(layout.bottom, lay_out(plot).bottom) << "the frame keeps its place";
    const auto entries = lay_out_legend(whole, layout, legend_top(layout));
    ASSERT_EQ(entries.size(), 7U);
    EXPECT_EQ(entries[0].y, entries[1].y) << "beside each other where there is room";
    EXPECT_GT(entries[6].y, entries[2].y);
    EXPECT_LT(entries[6].y, whole.height);
    for (const LegendEntry &entry : entries) {
        EXPECT_GE(entry.x, layout.left);
        EXPECT_LT(entry.x + legend_line, layout.right);
    }
}

TEST(PaperColor, IsThePagesInItsLightTheme) {
    EXPECT_EQ(paper_color("s2"), (PaperColor{0x00, 0x72, 0xb2}));
    EXPECT_EQ(series_paper_color(2), paper_color("s2"));
    EXPECT_EQ(series_paper_color(style_b), paper_color("b"));
    EXPECT_EQ(series_paper_color({}), paper_color("front"));
    EXPECT_THROW((void)paper_color("none"), std::invalid_argument);
}

} // namespace
} // namespace sandbox

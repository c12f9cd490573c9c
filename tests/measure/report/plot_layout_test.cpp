#include "measure/report/plot_layout.h"

#include <gtest/gtest.h>
#include <limits>

namespace sandbox {
namespace {

PlotRequest request(std::vector<PlotPoint> points) {
    PlotRequest plot;
    plot.width = 200;
    plot.height = 100;
    plot.left = plot.right = plot.top = plot.bottom = 10;
    plot.series = {{"one", 0, std::move(points)}};
    return plot;
}

TEST(PlotLayout, EqualFactorsAreEqualDistancesOnALogarithmicScale) {
    const PlotLayout layout = lay_out(request({{1, 100, 1, 1, 0}, {10, 10, 10, 10, 1}, {100, 1, 100, 100, 2}}));
    const auto &p = layout.series[0].points;
    ASSERT_EQ(p.size(), 3U);
    EXPECT_NEAR(p[1].x - p[0].x, p[2].x - p[1].x, 1e-9);
    EXPECT_NEAR(p[1].y - p[0].y, p[2].y - p[1].y, 1e-9);
    EXPECT_LT(p[0].x, p[2].x);
    EXPECT_LT(p[0].y, p[2].y) << "y grows downwards, the error falls";
    EXPECT_GT(p[0].x, layout.left);
    EXPECT_LT(p[2].x, layout.right);
}

TEST(PlotLayout, TicksStandWhereTheirNumbersAre) {
    const PlotLayout layout = lay_out(request({{1, 1, 1, 1, 0}, {1000, 1000, 1000, 1000, 1}}));
    int labelled = 0;
    for (const PlotTick &tick : layout.x_ticks) {
        if (tick.label == "1") {
            EXPECT_NEAR(tick.at, layout.series[0].points[0].x, 1e-9);
        }
        if (tick.label == "1000") {
            EXPECT_NEAR(tick.at, layout.series[0].points[1].x, 1e-9);
        }
        labelled += tick.label.empty() ? 0 : 1;
    }
    EXPECT_EQ(labelled, 4);
    PlotRequest even = request({{0, 0, 0, 0, 0}, {10, 10, 10, 10, 1}});
    even.x_scale = even.y_scale = Scale::linear;
    EXPECT_EQ(lay_out(even).x_ticks.size(), 6U); // 0, 2, 4, 6, 8, 10
}

TEST(PlotLayout, WhatHasNoPlaceIsLeftOut) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const PlotLayout layout = lay_out(request({{1, 0, 1, 1, 0}, {1, infinite, 1, 1, 1}, {1, 1, 1, 1, 2}}));
    ASSERT_EQ(layout.series[0].points.size(), 1U);
    EXPECT_EQ(layout.series[0].points[0].tag, 2U);
    EXPECT_TRUE(lay_out(request({})).series[0].points.empty());
}

TEST(PlotLayout, TheFrontIsAStaircase) {
    PlotRequest plot = request({{1, 100, 1, 1, 7}, {10, 10, 10, 10, 8}});
    plot.front = {7, 8};
    const PlotLayout layout = lay_out(plot);
    ASSERT_EQ(layout.front.size(), 3U);
    EXPECT_EQ(layout.front[1].x, layout.front[2].x);
    EXPECT_EQ(layout.front[1].y, layout.front[0].y);
}

TEST(PlotLayout, ThePointUnderTheMouse) {
    const PlotLayout layout = lay_out(request({{1, 100, 1, 1, 7}, {10, 10, 10, 10, 8}}));
    const PlotPoint &p = layout.series[0].points[1];
    EXPECT_EQ(nearest_point(layout, p.x + 3, p.y, 5), 8U);
    EXPECT_FALSE(nearest_point(layout, p.x + 6, p.y, 5));
}

TEST(PlotLayout, SharesFillTheBar) {
    const auto pieces = lay_out_shares({{{1, 0, 3}}, {{0, 0, 0}}}, 100, 5, 80, 20, 12);
    ASSERT_EQ(pieces.size(), 2U) << "nothing has no piece";
    EXPECT_EQ(pieces[0].x, 100);
    EXPECT_EQ(pieces[0].width, 20);
    EXPECT_EQ(pieces[1].part, 2U);
    EXPECT_EQ(pieces[1].x, 120);
    EXPECT_EQ(pieces[1].width, 60);
}

} // namespace
} // namespace sandbox

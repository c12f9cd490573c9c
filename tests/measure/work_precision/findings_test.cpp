#include "measure/work_precision/claims.h"
#include "tools/english.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace sandbox {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

Norms norms(double size) { return {size, size / 2, 4 * size, 3 * size}; } // rmse, mean, max, p99

/// Rows of one technique on five rungs with the given errors.
WorkPrecision ladder(const std::vector<double> &errors, double arithmetic = 1e-9) {
    WorkPrecision measured;
    for (std::size_t i = 0; i < errors.size(); ++i) {
        measured.meshes.push_back({8 << i, i == 0, true, 100, {}});
        MeasuredRow row;
        row.plan = {i, Technique{.frequency = Frequency::per_vertex, .model = Model::phong}, RowGroup::ladder};
        row.errors = RowErrors{};
        row.errors->total.norms = norms(errors[i]);
        row.errors->split.interpolation = norms(errors[i] / 2);
        row.errors->split.arithmetic = norms(arithmetic);
        row.time = run_time({static_cast<double>(i + 1)});
        measured.rows.push_back(row);
    }
    return measured;
}

TEST(Findings, OrdersOfAnErrorThatFallsWithTheSquare) {
    const auto steps = convergence_orders(ladder({0.1, 0.1 / 4, 0.1 / 16, 0.1 / 64}));
    ASSERT_EQ(steps.size(), 3U);
    for (const OrderStep &step : steps) {
        EXPECT_NEAR(*step.total.max, 2, 1e-12);
        EXPECT_NEAR(*step.total.l2, 2, 1e-12);
        EXPECT_NEAR(*step.total.l1, 2, 1e-12);
        EXPECT_NEAR(*step.interpolation.l2, 2, 1e-12);
        EXPECT_EQ(step.fine, step.coarse + 1);
    }
    EXPECT_EQ(steps[0].settling, Settling::settling) << "one step alone says nothing";
    EXPECT_EQ(steps[1].settling, Settling::settled);
    EXPECT_EQ(steps[2].settling, Settling::settled);
}

TEST(Findings, OrdersThatHaveNotSettledAreMarked) {
    const auto steps = convergence_orders(ladder({0.1, 0.09, 0.09 / 4, 0.09 / 16, 1.5e-9}));
    ASSERT_EQ(steps.size(), 4U);
    EXPECT_EQ(steps[1].settling, Settling::settling);
    EXPECT_EQ(steps[2].settling, Settling::settled);
    EXPECT_EQ(steps[3].settling, Settling::floor) << "float32 is most of what is left";
    EXPECT_FALSE(convergence_orders(ladder({0.1, 0}))[0].total.l2);
    EXPECT_FALSE(convergence_orders(ladder({infinite, 0.1}))[0].total.l2);
}

TEST(Findings, TheFrontHoldsWhatNothingBeatsInBoth) {
    const std::vector<TimeAndError> points{{3, 1}, {1, 5}, {2, 6}, {2, 3}, {4, 1}, {0.5, infinite}, {1, 4}};
    EXPECT_EQ(pareto_front(points), (std::vector<std::size_t>{6, 3, 0}));
    EXPECT_TRUE(pareto_front(std::vector<TimeAndError>{}).empty());
}

TEST(Findings, TheCheapestWithinABound) {
    WorkPrecision measured = ladder({0.1, 0.003, 0.002});
    EXPECT_EQ(cheapest(measured, Model::phong, ErrorNorm::rmse, 1.0 / 255), 1U);
    EXPECT_EQ(cheapest(measured, Model::phong, ErrorNorm::max, 0.009), 2U);
    EXPECT_FALSE(cheapest(measured, Model::phong, ErrorNorm::rmse, 1e-5));
    EXPECT_FALSE(cheapest(measured, Model::lambert, ErrorNorm::rmse, 1));
    measured.rows[1].errors->total.norms = norms(infinite); // a pixel that is not finite
    EXPECT_EQ(cheapest(measured, Model::phong, ErrorNorm::rmse, 1.0 / 255), 2U);
    measured.rows[2].plan.group = RowGroup::claim;
    EXPECT_FALSE(cheapest(measured, Model::phong, ErrorNorm::rmse, 1.0 / 255)) << "nobody chooses a fault";
}

TEST(Findings, RunTimesWhoseQuartilesOverlapAreATie) {
    WorkPrecision measured = ladder({0.003, 0.002, 0.001, 0.1});
    const auto time = [&](std::size_t row, double lower, double median, double upper) {
        measured.rows[row].time = RunTime{{median}, lower, lower, median, upper};
    };
    time(0, 1.9, 2, 2.2);
    time(1, 2.1, 2.3, 2.5); // within the noise of row 0
    time(2, 2.3, 2.4, 2.5); // slower
    time(3, 1, 2, 3);       // not within the bound
    ASSERT_EQ(cheapest(measured, Model::phong, ErrorNorm::rmse, 1.0 / 255), 0U);
    EXPECT_EQ(ties_of(measured, 0, ErrorNorm::rmse, 1.0 / 255), (std::vector<std::size_t>{1}));
    EXPECT_EQ(ties_of(measured, 2, ErrorNorm::rmse, 1.0 / 255), (std::vector<std::size_t>{0, 1}));
}

TEST(Findings, RatiosAreOfTheSameRound) {
    WorkPrecision measured = ladder({0.1});
    MeasuredRow full = measured.rows[0];
    full.plan.group = RowGroup::full_program;
    full.plan.technique.program = Program::full;
    measured.rows[0].time = run_time({10, 20, 40});
    full.time = run_time({20, 40, 80}); // the machine slows down, the ratio does not
    measured.rows.push_back(full);
    const auto ratios = ratios_to_base(measured, RowGroup::full_program);
    ASSERT_EQ(ratios.size(), 1U);
    EXPECT_EQ(ratios[0].row, 1U);
    EXPECT_EQ(ratios[0].base, 0U);
    EXPECT_EQ(ratios[0].lower_quartile, 2);
    EXPECT_EQ(ratios[0].median, 2);
    EXPECT_EQ(ratios[0].upper_quartile, 2);
}

TEST(Findings, ClaimsAreAnsweredFromTheNumbers) {
    WorkPrecision measured = ladder({0.02});
    MeasuredRow pixel = measured.rows[0];
    pixel.plan.technique = Technique{.frequency = Frequency::per_pixel, .model = Model::phong};
    pixel.errors->total.norms = norms(0.01);
    MeasuredRow infinite_viewer = pixel;
    infinite_viewer.plan.group = RowGroup::claim;
    infinite_viewer.plan.technique.viewer = Viewer::infinite;
    infinite_viewer.errors->total.norms = norms(0.05);
    pixel.time = run_time({10, 10, 10});
    infinite_viewer.time = run_time({9, 9, 9});
    measured.rows = {pixel, infinite_viewer};
    const auto claims = answer_claims(english, measured);
    ASSERT_EQ(claims.size(), 1U);
    EXPECT_EQ(claims[0].row, 1U);
    EXPECT_EQ(claims[0].against, 0U);
    EXPECT_EQ(claims[0].finding, "5 times the error, 10 % less time");
    measured.rows[1].errors->total.compared_share = 0.4;
    EXPECT_EQ(answer_claims(english, measured)[0].finding, "too little is compared to say, 10 % less time");
}

} // namespace
} // namespace sandbox

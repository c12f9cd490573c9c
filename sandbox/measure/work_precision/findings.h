#pragma once

#include "measure/work_precision/run.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// What follows from the rows of a measurement. A row is named by its index.
namespace sandbox {

/// Names the rows of norm_quantities.
enum class ErrorNorm { rmse, mean, max, p99 };
/// Those of the total error that tables and plots show, in their order.
constexpr ErrorNorm error_norms[]{ErrorNorm::rmse, ErrorNorm::p99, ErrorNorm::max};
constexpr const Quantity<Norms> &quantity_of(ErrorNorm norm) { return norm_quantities[static_cast<std::size_t>(norm)]; }
std::string_view name_of(ErrorNorm norm);
double value_of(const Norms &norms, ErrorNorm norm);

std::string_view name_of(Frequency frequency);
std::string_view name_of(Model model);
std::string_view name_of(RowGroup group);

/// The row with this technique on this mesh.
std::optional<std::size_t> find_row(const WorkPrecision &measured, std::size_t mesh, const Technique &technique);
/// A frequency and a model with every key at its default: what a user chooses among. The other rows are there to be
/// compared with these.
bool is_base(const MeasuredRow &row);
/// How many rows have a mark: too little of their pictures is compared.
std::size_t marked_rows(const WorkPrecision &measured);
/// The models that some row has, in the order of technique.h's table.
std::vector<Model> models_of(const WorkPrecision &measured);
/// The same in the order in which pages list them: the other way round.
std::vector<Model> richest_first(const WorkPrecision &measured);
/// The mesh that is the scene's own.
std::size_t own_mesh(const WorkPrecision &measured);

/// Orders of convergence from one rung of the ladder to the next, whose triangles are half as wide:
/// p = log2(e_h / e_h/2). Nothing where either error is 0 or not finite.
struct Orders {
    std::optional<double> max, l2, l1;
};
inline constexpr Quantity<Orders> order_quantities[]{
    {"max", "max", "", "order of the largest error", &Orders::max},
    {"l2", "L2", "", "order of the root mean square error", &Orders::l2},
    {"l1", "L1", "", "order of the mean error", &Orders::l1},
};
enum class Settling {
    settled,  ///< the L2 order is within settled_within of that of the step before
    settling, ///< it is not, or this is the first step
    floor     ///< half of the error or more is float32 arithmetic: what is left has no order
};
constexpr double settled_within = 0.25;
std::string_view name_of(Settling settling);
struct OrderStep {
    std::size_t coarse = 0, fine = 0; ///< rows
    Orders total;                     ///< of the picture against the truth
    Orders interpolation;             ///< of the technique against per-pixel, both in double on the same mesh
    Settling settling = Settling::settling;
};
std::vector<OrderStep> convergence_orders(const WorkPrecision &measured);

struct TimeAndError {
    double time = 0, error = 0;
};
/// The indices, by time, of the points than which no other is both faster and closer. Points that are not finite are
/// left out.
std::vector<std::size_t> pareto_front(std::span<const TimeAndError> points);
/// The same over the base rows of one model, marked ones apart: each model is judged against its own truth.
std::vector<std::size_t> pareto_front(const WorkPrecision &measured, Model model, ErrorNorm norm);

constexpr double error_bounds[]{1.0 / 255, 1.0 / 1024, 1e-5};
/// The base row of least median time whose error is at most `bound`, over enough of its picture.
std::optional<std::size_t> cheapest(const WorkPrecision &measured, Model model, ErrorNorm norm, double bound);
/// The other base rows within the bound that noise alone may put behind `row`: a quarter of their frames took no longer
/// than the slowest quarter of its frames began with. By their median.
std::vector<std::size_t> ties_of(const WorkPrecision &measured, std::size_t row, ErrorNorm norm, double bound);

/// How much longer `row` takes than `base`: quartiles of the quotients of each round's two times, so that drift
/// cancels.
struct TimeRatio {
    std::size_t row = 0, base = 0;
    double lower_quartile = 1, median = 1, upper_quartile = 1;
};
std::optional<TimeRatio> time_ratio(const WorkPrecision &measured, std::size_t row, std::size_t base);

/// The row that a variant is compared with: the same frequency and model with every key at its default, on its mesh.
std::optional<std::size_t> base_of(const WorkPrecision &measured, std::size_t row);

/// Every row of a group against its base: full programs against specialised ones, other powers against auto.
std::vector<TimeRatio> ratios_to_base(const WorkPrecision &measured, RowGroup group);

} // namespace sandbox

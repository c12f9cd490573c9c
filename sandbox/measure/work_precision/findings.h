#pragma once

#include "measure/work_precision/run.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// What the rows of a measurement say. Rows are named by their index.
namespace sandbox {

/// Of the total error, in the order that tables show them.
enum class ErrorNorm { rmse, p99, max };
constexpr ErrorNorm error_norms[]{ErrorNorm::rmse, ErrorNorm::p99, ErrorNorm::max};
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
/// The models that some row has, in the order lambert, phong, blinn-phong.
std::vector<Model> models_of(const WorkPrecision &measured);
/// The mesh that is the scene's own.
std::size_t own_mesh(const WorkPrecision &measured);

/// Of the convergence from one rung of the ladder to the next, half as wide: p = log2(e_h / e_h/2). Nothing where
/// either error is 0 or not finite.
struct Orders {
    std::optional<double> max, l2, l1;
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
/// The indices of the points that no other beats in both, by time. Points that are not finite are never among them.
std::vector<std::size_t> pareto_front(std::span<const TimeAndError> points);
/// The same over the base rows of one model: each model is judged against its own truth.
std::vector<std::size_t> pareto_front(const WorkPrecision &measured, Model model, ErrorNorm norm);

constexpr double error_bounds[]{1.0 / 255, 1.0 / 1024, 1e-5};
/// The base row of least median time whose error is at most `bound`.
std::optional<std::size_t> cheapest(const WorkPrecision &measured, Model model, ErrorNorm norm, double bound);

/// How much longer `row` takes than `base`: the quotient of each round's two times, so that drift cancels.
struct TimeRatio {
    std::size_t row = 0, base = 0;
    double lower_quartile = 1, median = 1, upper_quartile = 1;
};
std::optional<TimeRatio> time_ratio(const WorkPrecision &measured, std::size_t row, std::size_t base);

/// What a variant is a variant of: the same frequency and model with every key at its default, on the same mesh.
std::optional<std::size_t> base_of(const WorkPrecision &measured, std::size_t row);

/// Full programs against the specialised ones; stable or textbook power against auto.
std::vector<TimeRatio> ratios_to_base(const WorkPrecision &measured, RowGroup group);

/// A claim of the kind that tutorials make, answered by two rows on the scene's own mesh.
struct Claim {
    std::string says;
    std::size_t row = 0, against = 0;
    TimeRatio time;
    std::string finding; ///< in words, from the numbers alone
};
std::vector<Claim> answer_claims(const WorkPrecision &measured);

} // namespace sandbox

#include "measure/work_precision/findings.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sandbox {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

TimeAndError time_and_error(const MeasuredRow &row, Model model, ErrorNorm norm) {
    const bool counts = row.complete() && row.mark().empty() && is_base(row) && row.plan.technique.model == model;
    return counts ? TimeAndError{row.time->median, value_of(row.errors->total.norms, norm)}
                  : TimeAndError{infinite, infinite};
}

std::optional<double> order(double coarse, double fine) {
    const bool usable = std::isfinite(coarse) && std::isfinite(fine) && coarse > 0 && fine > 0;
    return usable ? std::optional(std::log2(coarse / fine)) : std::nullopt;
}

Orders orders(const Norms &coarse, const Norms &fine) {
    return {order(coarse.max_abs, fine.max_abs), order(coarse.rmse, fine.rmse), order(coarse.mean_abs, fine.mean_abs)};
}

Settling settling_of(const OrderStep &step, const RowErrors &fine, const OrderStep *before) {
    if (!step.total.l2 || fine.total.norms.rmse <= 2 * fine.split.arithmetic.rmse) {
        return Settling::floor;
    }
    const bool settled =
        before != nullptr && before->total.l2 && std::abs(*step.total.l2 - *before->total.l2) <= settled_within;
    return settled ? Settling::settled : Settling::settling;
}

/// The steps of one technique up the ladder.
void add_steps(const WorkPrecision &measured, const Technique &technique, std::vector<OrderStep> &steps) {
    std::optional<std::size_t> coarse;
    bool first = true;
    for (std::size_t mesh = 0; mesh < measured.meshes.size(); ++mesh) {
        const auto fine = measured.meshes[mesh].ladder ? find_row(measured, mesh, technique) : std::nullopt;
        if (!fine || !measured.rows[*fine].errors || !measured.rows[*fine].mark().empty()) {
            continue;
        }
        if (coarse) {
            const RowErrors &c = *measured.rows[*coarse].errors;
            const RowErrors &f = *measured.rows[*fine].errors;
            OrderStep step{*coarse, *fine, orders(c.total.norms, f.total.norms),
                           orders(c.split.interpolation, f.split.interpolation), Settling::settling};
            step.settling = settling_of(step, f, first ? nullptr : &steps.back());
            steps.push_back(step);
            first = false;
        }
        coarse = fine;
    }
}

} // namespace

std::string_view name_of(ErrorNorm norm) { return quantity_of(norm).heading; }
double value_of(const Norms &norms, ErrorNorm norm) { return quantity_of(norm).value(norms).value_or(infinite); }
std::string_view name_of(Frequency frequency) { return frequency_values[static_cast<std::size_t>(frequency)].name; }
std::string_view name_of(Model model) { return model_values[static_cast<std::size_t>(model)].name; }
std::string_view name_of(RowGroup group) {
    constexpr std::string_view names[]{"ladder", "own-mesh", "full-program", "baked-program",
                                       "power",  "claim",    "precision"};
    return names[static_cast<std::size_t>(group)];
}
std::string_view name_of(Settling settling) {
    constexpr std::string_view names[]{"settled", "settling", "floor"};
    return names[static_cast<std::size_t>(settling)];
}

std::optional<std::size_t> find_row(const WorkPrecision &measured, std::size_t mesh, const Technique &technique) {
    const auto found = std::ranges::find_if(measured.rows, [&](const MeasuredRow &row) {
        return row.plan.mesh == mesh && row.plan.technique == technique;
    });
    return found == measured.rows.end() ? std::nullopt
                                        : std::optional(static_cast<std::size_t>(found - measured.rows.begin()));
}

bool is_base(const MeasuredRow &row) {
    return row.plan.group == RowGroup::ladder || row.plan.group == RowGroup::own_mesh;
}

std::size_t marked_rows(const WorkPrecision &measured) {
    return static_cast<std::size_t>(
        std::ranges::count_if(measured.rows, [](const MeasuredRow &row) { return !row.mark().empty(); }));
}

std::vector<Model> models_of(const WorkPrecision &measured) {
    std::vector<Model> models;
    for (const Model model : all_models) {
        if (std::ranges::any_of(measured.rows, [&](const auto &row) { return row.plan.technique.model == model; })) {
            models.push_back(model);
        }
    }
    return models;
}

std::vector<Model> richest_first(const WorkPrecision &measured) {
    const std::vector<Model> models = models_of(measured);
    return {models.rbegin(), models.rend()};
}

std::size_t own_mesh(const WorkPrecision &measured) {
    const auto own = std::ranges::find_if(measured.meshes, &PlannedMesh::own);
    return own == measured.meshes.end() ? 0 : static_cast<std::size_t>(own - measured.meshes.begin());
}

std::vector<OrderStep> convergence_orders(const WorkPrecision &measured) {
    std::vector<OrderStep> steps;
    std::vector<Technique> seen;
    for (const MeasuredRow &row : measured.rows) {
        const Technique &technique = row.plan.technique;
        if (row.plan.group == RowGroup::ladder && std::ranges::find(seen, technique) == seen.end()) {
            seen.push_back(technique);
            add_steps(measured, technique, steps);
        }
    }
    return steps;
}

std::vector<std::size_t> pareto_front(std::span<const TimeAndError> points) {
    std::vector<std::size_t> by_time;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (std::isfinite(points[i].time) && std::isfinite(points[i].error)) {
            by_time.push_back(i);
        }
    }
    std::ranges::stable_sort(by_time, [&](std::size_t a, std::size_t b) {
        return points[a].time != points[b].time ? points[a].time < points[b].time : points[a].error < points[b].error;
    });
    std::vector<std::size_t> front;
    for (const std::size_t i : by_time) {
        if (front.empty() || points[i].error < points[front.back()].error) {
            front.push_back(i);
        }
    }
    return front;
}

std::vector<std::size_t> pareto_front(const WorkPrecision &measured, Model model, ErrorNorm norm) {
    std::vector<TimeAndError> points;
    for (const MeasuredRow &row : measured.rows) {
        points.push_back(time_and_error(row, model, norm));
    }
    return pareto_front(points);
}

std::vector<std::size_t> ties_of(const WorkPrecision &measured, std::size_t row, ErrorNorm norm, double bound) {
    const Model model = measured.rows[row].plan.technique.model;
    std::vector<std::size_t> ties;
    for (std::size_t i = 0; i < measured.rows.size(); ++i) {
        if (i != row && time_and_error(measured.rows[i], model, norm).error <= bound &&
            measured.rows[i].time->lower_quartile <= measured.rows[row].time->upper_quartile) {
            ties.push_back(i);
        }
    }
    std::ranges::sort(ties, {}, [&](std::size_t i) { return measured.rows[i].time->median; });
    return ties;
}

std::optional<std::size_t> cheapest(const WorkPrecision &measured, Model model, ErrorNorm norm, double bound) {
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < measured.rows.size(); ++i) {
        const TimeAndError point = time_and_error(measured.rows[i], model, norm);
        if (point.error <= bound && (!best || point.time < measured.rows[*best].time->median)) {
            best = i;
        }
    }
    return best;
}

std::optional<TimeRatio> time_ratio(const WorkPrecision &measured, std::size_t row, std::size_t base) {
    const auto &a = measured.rows[row].time;
    const auto &b = measured.rows[base].time;
    if (!a || !b) {
        return std::nullopt;
    }
    std::vector<double> quotients;
    for (std::size_t i = 0; i < std::min(a->samples.size(), b->samples.size()); ++i) {
        quotients.push_back(a->samples[i] / b->samples[i]);
    }
    const RunTime q = run_time(std::move(quotients));
    return TimeRatio{row, base, q.lower_quartile, q.median, q.upper_quartile};
}

std::optional<std::size_t> base_of(const WorkPrecision &measured, std::size_t row) {
    const PlannedRow &plan = measured.rows[row].plan;
    const Technique base{.frequency = plan.technique.frequency, .model = plan.technique.model};
    return base == plan.technique ? std::nullopt : find_row(measured, plan.mesh, base);
}

std::vector<TimeRatio> ratios_to_base(const WorkPrecision &measured, RowGroup group) {
    std::vector<TimeRatio> ratios;
    for (std::size_t i = 0; i < measured.rows.size(); ++i) {
        const auto base = measured.rows[i].plan.group == group ? base_of(measured, i) : std::nullopt;
        const auto ratio = base ? time_ratio(measured, i, *base) : std::nullopt;
        if (ratio) {
            ratios.push_back(*ratio);
        }
    }
    return ratios;
}

} // namespace sandbox

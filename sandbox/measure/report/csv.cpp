#include "measure/report/csv.h"

#include "measure/work_precision/findings.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>

namespace sandbox {
namespace {

std::string quoted(const std::string &text) {
    if (text.find_first_of(",\"\n\r") == std::string::npos) {
        return text;
    }
    std::string out = "\"";
    for (const char c : text) {
        out += c == '"' ? std::string("\"\"") : std::string(1, c);
    }
    return out + "\"";
}

void add_errors(CsvTable &table, const RowErrors &errors) {
    for_each_metric(errors.total, [&](const auto &metric, const auto &measured) {
        if (!metric.costly) {
            table.cell(std::string(metric.name), metric, measured);
        }
    });
    for (const ErrorPart &part : error_parts) {
        if (const Norms *norms = part.norms(errors.split)) {
            for (const Quantity<Norms> &norm : norm_quantities) {
                table.cell(fmt::format("{}_{}", part.name, norm.name), norm, *norms);
            }
        }
    }
}

void add_time(CsvTable &table, const RunTime &time) {
    for (const Quantity<RunTime> &quantity : run_time_quantities) {
        table.cell(fmt::format("{}_ms", quantity.name), quantity, time);
    }
    table.cell("samples", static_cast<double>(time.samples.size()));
}

void add_ratio(CsvTable &table, const std::string &name, const std::optional<TimeRatio> &ratio) {
    if (ratio) {
        table.cell("time_ratio_to_" + name, ratio->median);
        table.cell("time_ratio_to_" + name + "_lower_quartile", ratio->lower_quartile);
        table.cell("time_ratio_to_" + name + "_upper_quartile", ratio->upper_quartile);
    }
}

/// Time ratios to the technique's own default, and to per-pixel and per-vertex of its model, on its mesh.
void add_ratios(CsvTable &table, const WorkPrecision &measured, std::size_t row) {
    const PlannedRow &plan = measured.rows[row].plan;
    const auto to = [&](Frequency frequency) -> std::optional<TimeRatio> {
        const Technique technique{.frequency = frequency, .model = plan.technique.model};
        const auto base = find_row(measured, plan.mesh, technique);
        return base ? time_ratio(measured, row, *base) : std::nullopt;
    };
    const auto base = base_of(measured, row);
    add_ratio(table, "default", base ? time_ratio(measured, row, *base) : std::nullopt);
    add_ratio(table, "per_pixel", to(Frequency::per_pixel));
    add_ratio(table, "per_vertex", to(Frequency::per_vertex));
}

void add_step(CsvTable &table, const OrderStep &step) {
    const auto add = [&](const char *prefix, const Orders &orders) {
        for (const Quantity<Orders> &order : order_quantities) {
            if (order.value(orders)) {
                table.cell(fmt::format("{}order_{}", prefix, order.name), order, orders);
            }
        }
    };
    add("", step.total);
    add("interpolation_", step.interpolation);
    table.cell("settling", name_of(step.settling));
}

/// Which fronts a row is on, and under which bounds it is the cheapest.
void add_distinctions(CsvTable &table, const WorkPrecision &measured, std::size_t row) {
    const Model model = measured.rows[row].plan.technique.model;
    for (const ErrorNorm norm : error_norms) {
        const std::string_view key = quantity_of(norm).name;
        const std::string name(key.substr(0, key.find('_'))); // "p99" of "p99_abs"
        const auto front = pareto_front(measured, model, norm);
        table.cell("pareto_" + name, std::ranges::find(front, row) != front.end() ? 1.0 : 0.0);
        std::string bounds;
        for (const double bound : error_bounds) {
            if (cheapest(measured, model, norm, bound) == row) {
                bounds += fmt::format("{}{:f}", bounds.empty() ? "" : ";", bound);
            }
        }
        table.cell("cheapest_under_" + name, bounds);
    }
}

void add_run(CsvTable &table, const ReportRun &run, std::size_t number) {
    const WorkPrecision &m = run.measured;
    const auto steps = convergence_orders(m);
    for (std::size_t i = 0; i < m.rows.size(); ++i) {
        const MeasuredRow &row = m.rows[i];
        const PlannedMesh &mesh = m.meshes[row.plan.mesh];
        table.begin_row();
        table.cell("run", static_cast<double>(number));
        table.cell("scene", m.scene.name);
        table.cell("technique", to_string(row.plan.technique));
        table.cell("group", name_of(row.plan.group));
        table.cell("rings", mesh.rings);
        table.cell("own_mesh", mesh.own ? 1.0 : 0.0);
        table.cell("triangles", static_cast<double>(mesh.triangles));
        table.cell("width", m.options.size.width);
        table.cell("height", m.options.size.height);
        table.cell("renderer", run.machine.renderer);
        table.cell("opengl", run.machine.opengl);
        table.cell("processor", run.machine.processor);
        table.cell("version", run.version);
        table.cell("finished", m.finished ? 1.0 : 0.0);
        table.cell("refused", row.refused);
        if (row.time) {
            add_time(table, *row.time);
        }
        if (row.errors) {
            add_errors(table, *row.errors);
            table.cell("marked", row.mark());
        }
        add_ratios(table, m, i);
        const auto step = std::ranges::find(steps, i, &OrderStep::fine);
        if (step != steps.end()) {
            add_step(table, *step);
        }
        add_distinctions(table, m, i);
    }
}

} // namespace

void CsvTable::cell(const std::string &column, std::string_view text) {
    const auto [number, added] = column_numbers_.try_emplace(column, columns_.size());
    if (added) {
        columns_.push_back(column);
    }
    rows_.back().resize(std::max(rows_.back().size(), number->second + 1));
    rows_.back()[number->second] = text;
}

void CsvTable::cell(const std::string &column, double value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value);
    cell(column, std::isnan(value) ? "" : std::isfinite(value) ? std::string_view(text, end.ptr) : "inf");
}

std::string CsvTable::text() const {
    std::string out;
    const auto add_line = [&](const std::vector<std::string> &cells) {
        for (std::size_t i = 0; i < columns_.size(); ++i) {
            out += (i > 0 ? "," : "") + (i < cells.size() ? quoted(cells[i]) : std::string());
        }
        out += "\r\n";
    };
    add_line(columns_);
    for (const auto &row : rows_) {
        add_line(row);
    }
    return out;
}

std::string report_csv(const std::vector<ReportRun> &runs) {
    CsvTable table;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        add_run(table, runs[i], i + 1);
    }
    return table.text();
}

} // namespace sandbox

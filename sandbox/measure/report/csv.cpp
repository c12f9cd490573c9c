#include "measure/report/report.h"

#include "measure/work_precision/findings.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

namespace sandbox {
namespace {

/// Columns in the order of their first cell; a row may leave any of them empty.
class Table {
  public:
    void begin_row() { rows_.emplace_back(); }
    void cell(const std::string &column, const std::string &text) {
        const auto [place, added] = place_.try_emplace(column, columns_.size());
        if (added) {
            columns_.push_back(column);
        }
        rows_.back().resize(std::max(rows_.back().size(), place->second + 1));
        rows_.back()[place->second] = text;
    }
    /// The shortest text that reads back as the same number.
    void cell(const std::string &column, double value) {
        char text[32];
        const auto end = std::to_chars(text, text + sizeof text, value);
        cell(column, std::isfinite(value) ? std::string(text, end.ptr) : "inf");
    }
    [[nodiscard]] std::string text() const {
        std::string out;
        add_line(out, columns_);
        for (const auto &row : rows_) {
            add_line(out, row);
        }
        return out;
    }

  private:
    static std::string quoted(const std::string &text) {
        if (text.find_first_of(",\"\n\r") == std::string::npos) {
            return text;
        }
        std::string out = "\"";
        for (const char c : text) {
            out += c == '"' ? std::string("\"\"") : std::string(1, c);
        }
        return out + "\"";
    }
    void add_line(std::string &out, const std::vector<std::string> &cells) const {
        for (std::size_t i = 0; i < columns_.size(); ++i) {
            out += (i > 0 ? "," : "") + (i < cells.size() ? quoted(cells[i]) : std::string());
        }
        out += "\r\n"; // RFC 4180
    }

    std::vector<std::string> columns_;
    std::map<std::string, std::size_t> place_;
    std::vector<std::vector<std::string>> rows_;
};

void add_norms(Table &table, const std::string &prefix, const Norms &norms) {
    table.cell(prefix + "rmse", norms.rmse);
    table.cell(prefix + "mean_abs", norms.mean_abs);
    table.cell(prefix + "max_abs", norms.max_abs);
    table.cell(prefix + "p99_abs", norms.p99_abs);
}

void add_errors(Table &table, const RowErrors &errors) {
    const Metrics &total = errors.total;
    table.cell("nonfinite_pixels", static_cast<double>(total.nonfinite_pixels));
    add_norms(table, "", total.norms);
    table.cell("max_levels", total.max_levels);
    table.cell("differing_share", total.differing_share);
    table.cell("psnr", total.psnr ? *total.psnr : INFINITY);
    table.cell("compared_pixels", static_cast<double>(total.compared_pixels));
    table.cell("silhouette_pixels", static_cast<double>(total.silhouette_pixels));
    table.cell("edge_pixels", static_cast<double>(total.edge_pixels));
    table.cell("jump_pixels", static_cast<double>(total.jump_pixels));
    add_norms(table, "interpolation_", errors.split.interpolation);
    if (errors.split.geometry) {
        add_norms(table, "geometry_", *errors.split.geometry);
    }
    add_norms(table, "arithmetic_", errors.split.arithmetic);
    add_norms(table, "quantisation_", errors.split.quantisation);
}

void add_time(Table &table, const RunTime &time) {
    table.cell("median_ms", time.median);
    table.cell("min_ms", time.min);
    table.cell("lower_quartile_ms", time.lower_quartile);
    table.cell("upper_quartile_ms", time.upper_quartile);
    table.cell("samples", static_cast<double>(time.samples.size()));
}

void add_ratio(Table &table, const std::string &name, const std::optional<TimeRatio> &ratio) {
    if (ratio) {
        table.cell("time_ratio_to_" + name, ratio->median);
        table.cell("time_ratio_to_" + name + "_lower_quartile", ratio->lower_quartile);
        table.cell("time_ratio_to_" + name + "_upper_quartile", ratio->upper_quartile);
    }
}

/// Against its own default, and against per-pixel and per-vertex of its model on its mesh.
void add_ratios(Table &table, const WorkPrecision &measured, std::size_t row) {
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

void add_step(Table &table, const OrderStep &step) {
    const auto add = [&](const std::string &name, const std::optional<double> &p) {
        if (p) {
            table.cell(name, *p);
        }
    };
    add("order_max", step.total.max);
    add("order_l2", step.total.l2);
    add("order_l1", step.total.l1);
    add("interpolation_order_max", step.interpolation.max);
    add("interpolation_order_l2", step.interpolation.l2);
    add("interpolation_order_l1", step.interpolation.l1);
    table.cell("settling", std::string(name_of(step.settling)));
}

/// Which fronts a row is on, and under which bounds it is the cheapest.
void add_distinctions(Table &table, const WorkPrecision &measured, std::size_t row) {
    const Model model = measured.rows[row].plan.technique.model;
    for (const ErrorNorm norm : error_norms) {
        const std::string name = norm == ErrorNorm::rmse ? "rmse" : norm == ErrorNorm::p99 ? "p99" : "max";
        const auto front = pareto_front(measured, model, norm);
        table.cell("pareto_" + name, std::ranges::find(front, row) != front.end() ? 1.0 : 0.0);
        std::string bounds;
        for (const double bound : error_bounds) {
            if (cheapest(measured, model, norm, bound) == row) {
                bounds += (bounds.empty() ? "" : ";") + std::to_string(bound);
            }
        }
        table.cell("cheapest_under_" + name, bounds);
    }
}

void add_run(Table &table, const ReportRun &run, std::size_t number) {
    const WorkPrecision &m = run.measured;
    const auto steps = convergence_orders(m);
    for (std::size_t i = 0; i < m.rows.size(); ++i) {
        const MeasuredRow &row = m.rows[i];
        const PlannedMesh &mesh = m.meshes[row.plan.mesh];
        table.begin_row();
        table.cell("run", static_cast<double>(number));
        table.cell("scene", m.scene.name);
        table.cell("technique", to_string(row.plan.technique));
        table.cell("group", std::string(name_of(row.plan.group)));
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

std::string report_csv(const std::vector<ReportRun> &runs) {
    Table table;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        add_run(table, runs[i], i + 1);
    }
    return table.text();
}

} // namespace sandbox

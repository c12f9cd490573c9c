#include "measure/report/text.h"
#include "measure/stability/stability.h"

#include <nlohmann/json.hpp>

#include <charconv>
#include <cmath>

namespace sandbox {
namespace {

using nlohmann::ordered_json;

std::string unit_name(ErrorUnit unit) { return unit == ErrorUnit::linear_color ? "linear colour" : "brightest value"; }

/// Infinity has no place in JSON.
ordered_json number(double value) { return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr); }

ordered_json row_json(const StabilityRow &row) {
    const Metrics &m = row.metrics;
    return {{"technique", to_string(row.technique)},
            {"passed", row.passed},
            {"error", number(row.error)},
            {"max_abs", number(m.norms.max_abs)},
            {"rmse", number(m.norms.rmse)},
            {"max_levels", m.max_levels},
            {"nonfinite_pixels", m.nonfinite_pixels},
            {"compared_pixels", m.compared_pixels},
            {"silhouette_pixels", m.silhouette_pixels},
            {"edge_pixels", m.edge_pixels},
            {"jump_pixels", m.jump_pixels}};
}

ordered_json result_json(const StabilityResult &result) {
    const StabilityCase &of = result.of;
    ordered_json rows = ordered_json::array();
    for (const StabilityRow &row : result.rows) {
        rows.push_back(row_json(row));
    }
    return {{"name", of.name},
            {"group", of.group},
            {"symptom", of.symptom},
            {"cause", of.cause},
            {"source", of.source},
            {"bound", of.bound},
            {"unit", unit_name(of.unit)},
            {"passed", result.passed()},
            {"cost", result.cost ? ordered_json(*result.cost) : ordered_json(nullptr)},
            {"textbook_form", of.textbook ? "the program with power=textbook" : "float32 on the processor"},
            {"textbook", row_json(result.textbook)},
            {"robust", rows}};
}

std::string shortest(double value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value);
    return std::isfinite(value) ? std::string(text, end.ptr) : "inf";
}

std::string padded(std::string text, std::size_t width) {
    text.resize(std::max(text.size(), width), ' ');
    return text;
}

} // namespace

std::string stability_json(const StabilityRun &run) {
    ordered_json cases = ordered_json::array();
    for (const StabilityResult &result : run.results) {
        cases.push_back(result_json(result));
    }
    const ordered_json all{{"format", "shading-sandbox stability 1"},
                           {"version", run.version},
                           {"renderer", run.renderer},
                           {"size", {stability_size.width, stability_size.height}},
                           {"cases", cases}};
    return all.dump(2) + "\n";
}

std::string stability_csv(const StabilityRun &run) {
    std::string out = "name,group,form,technique,bound,unit,error,max_levels,nonfinite_pixels,compared_pixels,"
                      "silhouette_pixels,edge_pixels,jump_pixels,passed,cost\r\n"; // RFC 4180
    const auto line = [&](const StabilityResult &result, const StabilityRow &row, const char *form, bool has_cost) {
        const Metrics &m = row.metrics;
        out += result.of.name + "," + result.of.group + "," + form + ",\"" + to_string(row.technique) + "\"," +
               shortest(result.of.bound) + "," + unit_name(result.of.unit) + "," + shortest(row.error) + "," +
               std::to_string(m.max_levels) + "," + std::to_string(m.nonfinite_pixels) + "," +
               std::to_string(m.compared_pixels) + "," + std::to_string(m.silhouette_pixels) + "," +
               std::to_string(m.edge_pixels) + "," + std::to_string(m.jump_pixels) + "," + (row.passed ? "yes" : "no") +
               "," + (has_cost && result.cost ? shortest(*result.cost) : "") + "\r\n";
    };
    for (const StabilityResult &result : run.results) {
        line(result, result.textbook, "textbook", false);
        for (std::size_t i = 0; i < result.rows.size(); ++i) {
            line(result, result.rows[i], "robust", i == 0);
        }
    }
    return out;
}

std::string bound_words(const StabilityCase &of) {
    return short_number(of.bound) + (of.unit == ErrorUnit::linear_color ? "" : " of the brightest value");
}

/// Exactly 1 is no measurement.
std::string cost_words(double cost) {
    return cost == 1 ? "none: the textbook's program, fed better numbers"
                     : short_number(cost) + " times the textbook's run time";
}

std::string stability_table(const StabilityRun &run) {
    std::size_t widest = 4;
    for (const StabilityResult &result : run.results) {
        widest = std::max(widest, result.of.name.size());
    }
    const auto error_text = [](const StabilityRow &row) {
        return row.metrics.nonfinite_pixels > 0 ? std::to_string(row.metrics.nonfinite_pixels) + " px NaN/inf"
                                                : short_number(row.error);
    };
    std::string out = padded("case", widest + 2) + padded("textbook", 16) + padded("robust", 16) + padded("bound", 10) +
                      padded("cost", 7) + "\n";
    for (const StabilityResult &result : run.results) {
        out += padded(result.of.name, widest + 2) + padded(error_text(result.textbook), 16) +
               padded(error_text(result.worst()), 16) + padded(short_number(result.of.bound), 10) +
               padded(result.cost ? short_number(*result.cost) : "", 7) + (result.passed() ? "ok" : "BROKEN") + "\n";
        for (const StabilityRow &row : result.rows) {
            if (!row.passed) {
                const Metrics &m = row.metrics;
                out += "    " + to_string(row.technique) + ": error " + error_text(row) + ", compared " +
                       std::to_string(m.compared_pixels) + ", silhouette " + std::to_string(m.silhouette_pixels) +
                       ", edge " + std::to_string(m.edge_pixels) + ", jump " + std::to_string(m.jump_pixels) + "\n";
            }
        }
    }
    return out;
}

} // namespace sandbox

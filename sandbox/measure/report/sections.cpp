#include "measure/report/sections.h"

#include "measure/report/html.h"
#include "measure/report/text.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace sandbox::html {
namespace {

std::string cheapest_card(const Words &words, const WorkPrecision &m) {
    const Model model = models_of(m).back();
    const auto row = cheapest(m, model, ErrorNorm::rmse, error_bounds[0]);
    const std::string top = fmt::format("Cheapest within one 8-bit level, {}", name_of(model));
    if (!row) {
        return card(top, "none", "no row that counts has an RMSE of 1/255 or less");
    }
    const MeasuredRow &found = m.rows[*row];
    return card(top, escaped(to_string(found.plan.technique)),
                fmt::format("{}, {} ms, RMSE {}", escaped(mesh_words(words, m.meshes[found.plan.mesh])),
                            milliseconds_text(found.time->median), short_number(found.errors->total.norms.rmse)),
                true);
}

std::string saving_card(const WorkPrecision &m) {
    std::vector<double> ratios;
    for (const TimeRatio &ratio : ratios_to_base(m, RowGroup::full_program)) {
        ratios.push_back(ratio.median);
    }
    if (ratios.empty()) {
        return {};
    }
    const std::size_t count = ratios.size();
    return card("Leaving out what is not needed saves",
                fmt::format("{} %", std::lround(100 * (1 - 1 / run_time(std::move(ratios)).median))),
                fmt::format("of the full program's time, median over {} techniques", count));
}

std::string truth_card(const WorkPrecision &m) {
    return card("Judged against", m.no_analytic_surface.empty() ? "the surfaces themselves" : "the finest mesh",
                "per pixel, in double precision", true);
}

std::string failures_card(const WorkPrecision &m) {
    const auto failed = std::ranges::count_if(
        m.rows, [](const MeasuredRow &row) { return row.errors && row.errors->total.nonfinite_pixels > 0; });
    return card("Rows with a pixel that is not finite", fmt::format("{}", failed),
                fmt::format("of {} rows measured", m.rows.size()));
}

/// Empty where there is no such row.
std::string marked_card(const WorkPrecision &m) {
    const std::size_t marked = marked_rows(m);
    return marked == 0
               ? ""
               : card("Rows of which less than half is compared", fmt::format("{}", marked),
                      fmt::format("of {} rows measured; they are in no plot and never recommended", m.rows.size()));
}

/// The head of a quantity's column; its unit and meaning show when the mouse rests on it.
template <class T> void add_head(std::vector<std::string> &heads, const Quantity<T> &quantity) {
    if (!quantity.heading.empty()) {
        heads.push_back(
            fmt::format(R"(<span title="{}; unit: {}">{}</span>)", quantity.meaning, quantity.unit, quantity.heading));
    }
}

std::vector<std::string> row_heads() {
    std::vector<std::string> heads{"technique", "rings", "triangles"};
    for (const Quantity<RunTime> &time : run_time_quantities) {
        add_head(heads, time);
    }
    heads.emplace_back("middle half");
    for_each_metric(Metrics{}, [&](const auto &metric, const auto &) { add_head(heads, metric); });
    for (const ErrorPart &part : error_parts) {
        heads.emplace_back(part.heading);
    }
    return heads;
}

void add_time(Table &table, const std::optional<RunTime> &time) {
    const auto add = [&](double ms) {
        time ? table.number(ms, milliseconds_text(ms)) : table.text("&ndash;", "q"); // stopped before it was timed
    };
    const RunTime shown = time.value_or(RunTime{});
    for (const Quantity<RunTime> &quantity : run_time_quantities) {
        if (!quantity.heading.empty()) {
            add(quantity.value(shown).value_or(0));
        }
    }
    add(shown.upper_quartile - shown.lower_quartile);
}

void add_errors(Table &table, const RowErrors &errors) {
    for_each_metric(errors.total, [&](const auto &metric, const auto &measured) {
        if (!metric.heading.empty()) {
            const bool bad = errors.total.nonfinite_pixels > 0;
            const bool marked = !why_untrusted(errors.total).empty();
            table.number(metric.value(measured).value_or(0), quantity_text(metric, measured),
                         bad              ? "bad"
                         : marked         ? "unsettled"
                         : metric.whole() ? "q"
                                          : "");
        }
    });
    for (const ErrorPart &part : error_parts) {
        table.number(part.rmse(errors.split), short_number(part.rmse(errors.split)), "q");
    }
}

void add_row(Table &table, const WorkPrecision &m, const MeasuredRow &row) {
    const PlannedMesh &mesh = m.meshes[row.plan.mesh];
    table.begin_row();
    const std::string mark = row.mark();
    table.text(technique_code(row.plan.technique) +
                   (mark.empty() ? "" : fmt::format(R"(<br><span class="q">{}</span>)", escaped(mark))),
               mark.empty() ? "" : "bad");
    table.number(mesh.rings, mesh.ladder ? fmt::format("{}", mesh.rings) : "own");
    table.number(static_cast<double>(mesh.triangles), fmt::format("{}", mesh.triangles));
    if (!row.refused.empty()) {
        table.rest("refused: " + escaped(row.refused), "q");
    } else if (!row.errors) {
        table.rest("not measured", "q");
    } else {
        add_time(table, row.time);
        add_errors(table, *row.errors);
    }
}

/// A term and its description; nothing where there is none.
std::string item(std::string_view term, std::string_view text) {
    return text.empty() ? "" : fmt::format("<dt>{}</dt><dd>{}</dd>\n", term, text);
}

} // namespace

std::string summary(const ReportRun &run) {
    const WorkPrecision &m = run.measured;
    return m.rows.empty() ? ""
                          : fmt::format("<div class=\"cards\">{}{}{}{}{}</div>\n", cheapest_card(run.words, m),
                                        saving_card(m), truth_card(m), failures_card(m), marked_card(m));
}

std::string all_rows(const ReportRun &run) {
    Table table(row_heads());
    for (const MeasuredRow &row : run.measured.rows) {
        add_row(table, run.measured, row);
    }
    return section("rows", "Every row",
                   "Errors in linear colour over all three channels of the pixels where the picture and the truth show "
                   "the same object; pixels at silhouettes, at edges between triangles, at jumps of the equation and "
                   "where rounding alone decides are only counted. A row of which less than half is compared is "
                   "marked: it is in no plot and never recommended. The four parts of the error, in the last columns, "
                   "are root mean squares.",
                   table.html());
}

std::string method(const ReportRun &run) {
    const WorkPrecision &m = run.measured;
    const Machine &machine = run.machine;
    std::vector<std::string> omitted, spent;
    for (const OmittedRow &row : m.omitted) {
        omitted.push_back(fmt::format("<code>{}</code>: {}", escaped(row.technique), escaped(row.reason)));
    }
    for (const Quantity<Accounting> &part : accounting_quantities) {
        spent.push_back(fmt::format("{:.1f} s {}", part.value(m.seconds).value_or(0), part.heading));
    }
    const std::string list =
        item("Renderer", fmt::format("{}, OpenGL {}", escaped(machine.renderer), escaped(machine.opengl))) +
        item("Processor", fmt::format("{}, {} threads", escaped(machine.processor), machine.threads)) +
        item("LP_NUM_THREADS", machine.llvmpipe_threads.empty() ? "not set" : escaped(machine.llvmpipe_threads)) +
        item("Program", fmt::format("Shading Sandbox {}, {}", escaped(run.version), escaped(machine.build))) +
        item("Clock", escaped(machine.clock)) +
        item("Rounds", fmt::format("{} dropped, then {} timed; every row is drawn once a round, so that drift reaches "
                                   "all alike",
                                   m.options.warm_ups, m.options.repeats)) +
        item("Frame", "clear, draw, finish, into RGBA32F; no object ids, no display pass, one sample a pixel") +
        item("Truth",
             "the same equation per pixel in double, on the " +
                 (m.no_analytic_surface.empty() ? "analytic surfaces"
                                                : fmt::format("finest mesh ({})", escaped(m.no_analytic_surface)))) +
        item("Ladder", fmt::format("{} to {} rings; all shapes are refined in proportion, models from files keep their "
                                   "mesh",
                                   m.options.first_rings, m.options.last_rings)) +
        item("Left out", fmt::format("{}", fmt::join(omitted, "; "))) +
        item("Spent", fmt::format("{}", fmt::join(spent, ", "))) +
        item("Files",
             "report.json and report.csv beside this page hold every number of it; a report that is made again "
             "on the same machine has the same errors to the last digit");
    return section("method", "Machine and method", "", "<dl>" + list + "</dl>\n");
}

} // namespace sandbox::html

#include "measure/report/page.h"
#include "measure/report/text.h"

#include <algorithm>
#include <cmath>

namespace sandbox::report_page {
namespace {

std::string card(const std::string &top, const std::string &big, const std::string &below, bool words = false) {
    return "<div class=\"card\"><span class=\"top\">" + top + "</span><b" + (words ? " class=\"words\"" : "") + ">" +
           big + "</b><span>" + below + "</span></div>\n";
}

std::string cheapest_card(const WorkPrecision &m) {
    const Model model = models_of(m).back();
    const auto row = cheapest(m, model, ErrorNorm::rmse, error_bounds[0]);
    const std::string top = "Cheapest within one 8-bit level, " + std::string(name_of(model));
    if (!row) {
        return card(top, "none", "no row has an RMSE of 1/255 or less");
    }
    const MeasuredRow &found = m.rows[*row];
    return card(top, escaped(to_string(found.plan.technique)),
                escaped(mesh_words(m.meshes[found.plan.mesh])) + ", " + milliseconds_text(found.time->median) +
                    " ms, RMSE " + short_number(found.errors->total.norms.rmse),
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
    const RunTime spread = run_time(ratios);
    return card("Leaving out what is not needed saves",
                std::to_string(std::lround(100 * (1 - 1 / spread.median))) + " %",
                "of the full program's time, median over " + std::to_string(ratios.size()) + " techniques");
}

std::string truth_card(const WorkPrecision &m) {
    const bool analytic = m.no_analytic_surface.empty();
    return card("Judged against", analytic ? "the surfaces themselves" : "the finest mesh",
                "per pixel, in double precision", true);
}

std::string failures_card(const WorkPrecision &m) {
    const auto failed = std::ranges::count_if(
        m.rows, [](const MeasuredRow &row) { return row.errors && row.errors->total.nonfinite_pixels > 0; });
    return card("Rows with a pixel that is not finite", std::to_string(failed),
                "of " + std::to_string(m.rows.size()) + " rows measured");
}

std::string count(std::size_t value) { return std::to_string(value); }

void add_row(HtmlTable &table, const WorkPrecision &m, const MeasuredRow &row) {
    const PlannedMesh &mesh = m.meshes[row.plan.mesh];
    table.begin_row();
    table.text(technique_html(row.plan.technique));
    table.number(mesh.rings, mesh.ladder ? std::to_string(mesh.rings) : "own");
    table.number(static_cast<double>(mesh.triangles), count(mesh.triangles));
    if (!row.refused.empty()) {
        table.text("refused: " + escaped(row.refused), "q\" colspan=\"16");
        return;
    }
    if (row.time) {
        const RunTime &time = *row.time;
        table.number(time.median, milliseconds_text(time.median));
        table.number(time.upper_quartile - time.lower_quartile,
                     milliseconds_text(time.upper_quartile - time.lower_quartile), "q");
        table.number(time.min, milliseconds_text(time.min), "q");
    } else {
        table.text("not timed", "q\" colspan=\"3");
    }
    if (!row.errors) {
        table.text("not judged", "q\" colspan=\"13");
        return;
    }
    const Metrics &e = row.errors->total;
    const ErrorSplit &split = row.errors->split;
    table.number(static_cast<double>(e.nonfinite_pixels), count(e.nonfinite_pixels),
                 e.nonfinite_pixels > 0 ? "bad" : "q");
    for (const double value : {e.norms.rmse, e.norms.mean_abs, e.norms.p99_abs, e.norms.max_abs}) {
        table.number(value, short_number(value));
    }
    table.number(e.max_levels, std::to_string(e.max_levels));
    for (const double value : {split.interpolation.rmse, split.geometry ? split.geometry->rmse : 0,
                               split.arithmetic.rmse, split.quantisation.rmse}) {
        table.number(value, short_number(value), "q");
    }
    for (const std::size_t pixels : {e.silhouette_pixels, e.edge_pixels, e.jump_pixels}) {
        table.number(static_cast<double>(pixels), count(pixels), "q");
    }
}

std::string item(const std::string &term, const std::string &text) {
    return text.empty() ? std::string() : "<dt>" + term + "</dt><dd>" + text + "</dd>\n";
}

std::string seconds_text(double seconds) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f s", seconds);
    return text;
}

std::string omitted_list(const WorkPrecision &m) {
    std::string text;
    for (const OmittedRow &row : m.omitted) {
        text += (text.empty() ? "" : "; ") + ("<code>" + escaped(row.technique) + "</code>: ") + escaped(row.reason);
    }
    return text;
}

} // namespace

std::string summary(const ReportRun &run) {
    const WorkPrecision &m = run.measured;
    if (m.rows.empty()) {
        return {};
    }
    return "<div class=\"cards\">" + cheapest_card(m) + saving_card(m) + truth_card(m) + failures_card(m) + "</div>\n";
}

std::string all_rows(const ReportRun &run) {
    HtmlTable table;
    table.column("technique", false);
    for (const char *head : {"rings", "triangles", "median, ms", "middle half", "least", "not finite", "RMSE", "mean",
                             "99 %", "largest", "levels", "interpo&shy;lation", "geo&shy;metry", "arith&shy;metic",
                             "quanti&shy;sation", "silhou&shy;ettes", "edges", "jumps"}) {
        table.column(head);
    }
    for (const MeasuredRow &row : run.measured.rows) {
        add_row(table, run.measured, row);
    }
    return section("rows", "Every row",
                   "Errors in linear colour over all three channels of the pixels where the picture and the truth show "
                   "the same object; pixels at silhouettes, edges between triangles and jumps of the equation are "
                   "counted apart, in the last columns. The four parts are root mean squares.",
                   table.empty() ? std::string() : table.html());
}

std::string method(const ReportRun &run) {
    const WorkPrecision &m = run.measured;
    const Accounting &s = m.seconds;
    std::string list = "<dl>";
    list += item("Renderer", escaped(run.machine.renderer) + ", OpenGL " + escaped(run.machine.opengl));
    list += item("Processor", escaped(run.machine.processor) + ", " + std::to_string(run.machine.threads) + " threads");
    list += item("LP_NUM_THREADS",
                 run.machine.llvmpipe_threads.empty() ? "not set" : escaped(run.machine.llvmpipe_threads));
    list += item("Program", "Shading Sandbox " + escaped(run.version) + ", " + escaped(run.machine.build));
    list += item("Clock", escaped(run.machine.clock));
    list += item("Rounds", std::to_string(m.options.warm_ups) + " dropped, then " + std::to_string(m.options.repeats) +
                               " timed; every row is drawn once a round, so that drift reaches all alike");
    list += item("Frame", "clear, draw, finish, into RGBA32F; no object ids, no display pass, one sample a pixel");
    list +=
        item("Truth", m.no_analytic_surface.empty() ? "the same equation per pixel in double, on the analytic surfaces"
                                                    : "the same equation per pixel in double, on the finest mesh (" +
                                                          escaped(m.no_analytic_surface) + ")");
    list += item("Ladder", std::to_string(m.options.first_rings) + " to " + std::to_string(m.options.last_rings) +
                               " rings; all shapes are refined in proportion, models from files keep their mesh");
    list += item("Left out", omitted_list(m));
    list += item("Spent", seconds_text(s.drawing) + " drawing, " + seconds_text(s.reference) + " truth, " +
                              seconds_text(s.metrics) + " comparing, " + seconds_text(s.other) + " all else");
    list += item("Files", "report.json and report.csv beside this page hold every number of it; errors are the same to "
                          "the last digit whenever the report is made again on the same machine");
    return section("method", "Machine and method", "", list + "</dl>\n");
}

} // namespace sandbox::report_page

#include "measure/report/report_html.h"

#include "measure/report/figures.h"
#include "measure/report/html.h"
#include "measure/report/sections.h"
#include "measure/report/svg.h"
#include "measure/report/tables.h"
#include "measure/report/text.h"

#include <algorithm>
#include <fmt/format.h>

namespace sandbox {
namespace {

using namespace html;

std::string run_name(std::size_t i) { return fmt::format("Run {}", i + 1); }

std::string runs_table(const std::vector<ReportRun> &runs) {
    Table table({"run", "scene", "size", "renderer", "OpenGL", "processor", "build", "version", "date"});
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const ReportRun &run = runs[i];
        const Size size = run.measured.options.size;
        const std::string &llvmpipe = run.machine.llvmpipe_threads;
        table.begin_row();
        table.text(run_name(i) + (run.measured.finished ? "" : " (incomplete)"));
        table.text(escaped(run.measured.scene.name));
        table.text(fmt::format("{} &times; {}", size.width, size.height));
        table.text(escaped(run.machine.renderer));
        table.text(escaped(run.machine.opengl));
        table.text(fmt::format("{}, {} threads{}", escaped(run.machine.processor), run.machine.threads,
                               llvmpipe.empty() ? "" : ", LP_NUM_THREADS " + escaped(llvmpipe)));
        table.text(escaped(run.machine.build));
        table.text(escaped(run.version));
        table.text(escaped(run.date));
    }
    return table.html();
}

/// The row of another run with the same technique on a mesh of the same size.
const MeasuredRow *twin(const ReportRun &run, const MeasuredRow &row, const PlannedMesh &mesh) {
    const auto found = std::ranges::find_if(run.measured.rows, [&](const MeasuredRow &other) {
        const PlannedMesh &its_mesh = run.measured.meshes[other.plan.mesh];
        return other.plan.technique == row.plan.technique && its_mesh.rings == mesh.rings &&
               its_mesh.triangles == mesh.triangles;
    });
    return found == run.measured.rows.end() || !found->complete() ? nullptr : &*found;
}

std::string times_table(const std::vector<ReportRun> &runs) {
    std::vector<std::string> heads{"technique", "rings"};
    for (std::size_t i = 0; i < runs.size(); ++i) {
        heads.push_back(run_name(i) + ", ms");
        heads.emplace_back("RMSE");
        if (i > 0) {
            heads.emplace_back("time / Run 1");
        }
    }
    Table table(heads);
    const WorkPrecision &first = runs[0].measured;
    for (const MeasuredRow &row : first.rows) {
        const PlannedMesh &mesh = first.meshes[row.plan.mesh];
        table.begin_row();
        table.text(technique_code(row.plan.technique));
        table.number(mesh.rings, mesh.ladder ? fmt::format("{}", mesh.rings) : "own");
        for (std::size_t i = 0; i < runs.size(); ++i) {
            const auto add = [&](const std::optional<double> &value, std::string (*text)(double), const char *style) {
                value ? table.number(*value, text(*value), style) : table.text("&ndash;", "n q");
            };
            const MeasuredRow *found = twin(runs[i], row, mesh);
            const auto time = found != nullptr ? std::optional(found->time->median) : std::nullopt;
            add(time, milliseconds_text, "");
            add(found != nullptr ? std::optional(found->errors->total.norms.rmse) : std::nullopt, short_number,
                found == nullptr || found->mark().empty() ? "q" : "unsettled");
            if (i > 0) {
                add(time && row.time ? std::optional(*time / row.time->median) : std::nullopt, short_number, "");
            }
        }
    }
    return table.html();
}

/// One line per run: its front.
std::string fronts_plot(const std::vector<ReportRun> &runs, Model model) {
    PlotRequest plot;
    plot.title = fmt::format("{}: the fronts of all runs", name_of(model));
    plot.x_label = "median time of a frame, ms";
    plot.y_label = "root mean square error";
    std::vector<std::string> tips; // by tag
    for (std::size_t i = 0; i < runs.size(); ++i) {
        PlotSeries series{run_name(i), static_cast<int>(i), {}};
        for (const std::size_t row : pareto_front(runs[i].measured, model, ErrorNorm::rmse)) {
            const MeasuredRow &found = runs[i].measured.rows[row];
            series.points.push_back({found.time->median, found.errors->total.norms.rmse, found.time->lower_quartile,
                                     found.time->upper_quartile, tips.size()});
            tips.push_back(fmt::format("{}: {}", run_name(i), to_string(found.plan.technique)));
        }
        plot.series.push_back(std::move(series));
    }
    return plot_svg(plot, [&](std::size_t tag) { return tips[tag]; });
}

/// Several runs beside each other.
std::string comparison(const std::vector<ReportRun> &runs) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        names.push_back(fmt::format("{}: {}, {}", run_name(i), runs[i].machine.renderer, runs[i].version));
    }
    std::string plots;
    for (const Model model : richest_first(runs[0].measured)) {
        plots += fmt::format("<div>{}</div>\n", fronts_plot(runs, model));
    }
    return "<header><p class=\"kicker\">Error against run time</p><h1>Runs side by side</h1></header>\n" +
           section("runs", "The runs", "Each has its own report below.", runs_table(runs)) +
           section("fronts", "What is cheapest in each",
                   "For every run, the rows than which no other is both faster and "
                   "closer.",
                   legend_html(names, false) + "<div class=\"plots\">" + plots + "</div>\n") +
           section("twins", "Row by row", "Rows of the first run, and the same rows of the others.", times_table(runs));
}

std::string heading(const ReportRun &run) {
    const WorkPrecision &m = run.measured;
    std::string text =
        fmt::format(R"(<header><p class="kicker">Error against run time</p><h1>{}</h1>)", escaped(m.scene.name));
    if (!m.scene.description.empty()) {
        text += fmt::format(R"(<p class="lead">{}</p>)", escaped(m.scene.description));
    }
    text += fmt::format(
        R"(<p class="facts">{} &times; {} pixels &middot; {} &middot; Shading Sandbox {} &middot; {} UTC</p>)",
        m.options.size.width, m.options.size.height, escaped(run.machine.renderer), escaped(run.version),
        escaped(run.date));
    if (!m.finished) {
        text += "<p class=\"warning\">Incomplete: the measuring was stopped. What had been measured is here.</p>";
    }
    if (run.quick) {
        text += fmt::format("<p class=\"note\">A quick overview: {} timed rounds. For figures to quote, make the full "
                            "report.</p>",
                            m.options.repeats);
    }
    return text + "</header>\n";
}

} // namespace

std::string report_html(const std::vector<ReportRun> &runs) {
    std::string body = runs.size() > 1 ? comparison(runs) : "";
    for (const ReportRun &run : runs) {
        body += heading(run) + summary(run) + pictures(run) + error_against_time(run) + cheapest_rows(run) +
                order_ladder(run) + error_split(run) + claims(run) + specialisation(run) + power(run) + all_rows(run) +
                method(run);
    }
    return page(runs.empty() ? "Report" : runs[0].measured.scene.name + ": error against run time", body);
}

} // namespace sandbox

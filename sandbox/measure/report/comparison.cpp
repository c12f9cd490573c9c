#include "measure/report/page.h"
#include "measure/report/svg.h"
#include "measure/report/text.h"

#include <algorithm>

namespace sandbox::report_page {
namespace {

std::string run_name(std::size_t i) { return "Run " + std::to_string(i + 1); }

std::string runs_table(const std::vector<ReportRun> &runs) {
    HtmlTable table;
    for (const char *head : {"run", "scene", "size", "renderer", "OpenGL", "processor", "build", "version", "date"}) {
        table.column(head, false);
    }
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const ReportRun &run = runs[i];
        const Size size = run.measured.options.size;
        table.begin_row();
        table.text(run_name(i) + (run.measured.finished ? "" : " (incomplete)"));
        table.text(escaped(run.measured.scene.name));
        table.text(std::to_string(size.width) + " &times; " + std::to_string(size.height));
        table.text(escaped(run.machine.renderer));
        table.text(escaped(run.machine.opengl));
        table.text(
            escaped(run.machine.processor) + ", " + std::to_string(run.machine.threads) + " threads" +
            (run.machine.llvmpipe_threads.empty() ? "" : ", LP_NUM_THREADS " + escaped(run.machine.llvmpipe_threads)));
        table.text(escaped(run.machine.build));
        table.text(escaped(run.version));
        table.text(escaped(run.date));
    }
    return table.html();
}

/// The row of another run with the same technique on a mesh of the same name.
const MeasuredRow *twin(const ReportRun &run, const MeasuredRow &row, const PlannedMesh &mesh) {
    for (const MeasuredRow &other : run.measured.rows) {
        const PlannedMesh &its_mesh = run.measured.meshes[other.plan.mesh];
        if (other.plan.technique == row.plan.technique && its_mesh.rings == mesh.rings &&
            its_mesh.triangles == mesh.triangles) {
            return &other;
        }
    }
    return nullptr;
}

std::string times_table(const std::vector<ReportRun> &runs) {
    HtmlTable table;
    table.column("technique", false);
    table.column("rings");
    for (std::size_t i = 0; i < runs.size(); ++i) {
        table.column(run_name(i) + ", ms");
        table.column("RMSE");
        if (i > 0) {
            table.column("time / Run 1");
        }
    }
    const WorkPrecision &first = runs[0].measured;
    for (const MeasuredRow &row : first.rows) {
        const PlannedMesh &mesh = first.meshes[row.plan.mesh];
        table.begin_row();
        table.text(technique_html(row.plan.technique));
        table.number(mesh.rings, mesh.ladder ? std::to_string(mesh.rings) : "own");
        for (std::size_t i = 0; i < runs.size(); ++i) {
            const MeasuredRow *one = twin(runs[i], row, mesh);
            if (one == nullptr || !one->complete()) {
                table.text("&ndash;", i > 0 ? "n q\" colspan=\"3" : "n q\" colspan=\"2");
                continue;
            }
            table.number(one->time->median, milliseconds_text(one->time->median));
            table.number(one->errors->total.norms.rmse, short_number(one->errors->total.norms.rmse), "q");
            if (i > 0) {
                const double ratio = row.time ? one->time->median / row.time->median : 0;
                table.number(ratio, row.time ? short_number(ratio) : "&ndash;");
            }
        }
    }
    return table.html();
}

/// One line a run: its front.
std::string fronts_plot(const std::vector<ReportRun> &runs, Model model) {
    PlotRequest plot;
    plot.title = std::string(name_of(model)) + ": the fronts of all runs";
    plot.x_label = "median time of a frame, ms";
    plot.y_label = "root mean square error";
    for (std::size_t i = 0; i < runs.size(); ++i) {
        PlotSeries series{run_name(i), static_cast<int>(i), {}};
        for (const std::size_t row : pareto_front(runs[i].measured, model, ErrorNorm::rmse)) {
            const MeasuredRow &found = runs[i].measured.rows[row];
            series.points.push_back({found.time->median, found.errors->total.norms.rmse, found.time->lower_quartile,
                                     found.time->upper_quartile, i * 100000 + row});
        }
        plot.series.push_back(std::move(series));
    }
    return plot_svg(plot, [&](std::size_t tag) {
        const MeasuredRow &row = runs[tag / 100000].measured.rows[tag % 100000];
        return run_name(tag / 100000) + ": " + to_string(row.plan.technique);
    });
}

} // namespace

std::string comparison(const std::vector<ReportRun> &runs) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        names.push_back(run_name(i) + ": " + runs[i].machine.renderer + ", " + runs[i].version);
    }
    std::string plots;
    auto models = models_of(runs[0].measured);
    std::ranges::reverse(models);
    for (const Model model : models) {
        plots += "<div>" + fronts_plot(runs, model) + "</div>\n";
    }
    return "<header><p class=\"kicker\">Error against run time</p><h1>Runs side by side</h1></header>\n" +
           section("runs", "The runs", "Each has its own report below.", runs_table(runs)) +
           section("fronts", "What is cheapest in each", "For every run, the rows that no other beats in both.",
                   legend_html(names, false) + "<div class=\"plots\">" + plots + "</div>\n") +
           section("twins", "Row by row", "Rows of the first run, and their twins in the others.", times_table(runs));
}

} // namespace sandbox::report_page

#include "measure/report/report_html.h"

#include "measure/report/figures.h"
#include "measure/report/html.h"
#include "measure/report/sections.h"
#include "measure/report/svg.h"
#include "measure/report/tables.h"
#include "measure/report/text.h"
#include "words/row_words.h"

#include <algorithm>
#include <fmt/format.h>

namespace sandbox {
namespace {

using namespace html;

std::string run_name(const Words &words, std::size_t i) { return words.format("report.run", i + 1); }

std::string runs_table(const Words &words, const std::vector<ReportRun> &runs) {
    Table table(
        heads_of(words, {"run", "scene", "size", "renderer", "opengl", "processor", "build", "version", "date"}));
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const ReportRun &run = runs[i];
        const Size size = run.measured.options.size;
        const std::string &llvmpipe = run.machine.llvmpipe_threads;
        table.begin_row();
        table.text(run_name(words, i) + (run.measured.finished ? "" : words.text("report.incomplete")));
        table.text(escaped(file_text(words, run.measured.scene.name)));
        table.text(fmt::format("{} &times; {}", size.width, size.height));
        table.text(escaped(run.machine.renderer));
        table.text(escaped(run.machine.opengl));
        table.text(words.format("report.threads", escaped(run.machine.processor), run.machine.threads) +
                   (llvmpipe.empty() ? "" : ", LP_NUM_THREADS " + escaped(llvmpipe)));
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

std::string times_table(const Words &words, const std::vector<ReportRun> &runs) {
    std::vector<std::string> heads = heads_of(words, {"technique", "rings"});
    for (std::size_t i = 0; i < runs.size(); ++i) {
        heads.push_back(words.format("report.run_ms", run_name(words, i)));
        heads.emplace_back("RMSE");
        if (i > 0) {
            heads.push_back(words.text("report.time_ratio"));
        }
    }
    Table table(heads);
    const WorkPrecision &first = runs[0].measured;
    for (const MeasuredRow &row : first.rows) {
        const PlannedMesh &mesh = first.meshes[row.plan.mesh];
        table.begin_row();
        table.text(technique_code(row.plan.technique));
        table.number(mesh.rings, mesh.ladder ? fmt::format("{}", mesh.rings) : words.text("report.own"));
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
std::string fronts_plot(const Words &words, const std::vector<ReportRun> &runs, Model model) {
    PlotRequest plot;
    plot.title = words.format("report.fronts_of", title_of(words, model_key, static_cast<int>(model)));
    plot.x_label = words.text("plot.time");
    plot.y_label = long_title_of(words, ErrorNorm::rmse);
    std::vector<std::string> tips; // by tag
    for (std::size_t i = 0; i < runs.size(); ++i) {
        PlotSeries series{run_name(words, i), static_cast<int>(i), {}};
        for (const std::size_t row : pareto_front(runs[i].measured, model, ErrorNorm::rmse)) {
            const MeasuredRow &found = runs[i].measured.rows[row];
            series.points.push_back({found.time->median, found.errors->total.norms.rmse, found.time->lower_quartile,
                                     found.time->upper_quartile, tips.size()});
            tips.push_back(fmt::format("{}: {}", run_name(words, i), to_string(found.plan.technique)));
        }
        plot.series.push_back(std::move(series));
    }
    return plot_svg(plot, [&](std::size_t tag) { return tips[tag]; });
}

/// Several runs beside each other.
std::string comparison(const Words &words, const std::vector<ReportRun> &runs) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        names.push_back(fmt::format("{}: {}, {}", run_name(words, i), runs[i].machine.renderer, runs[i].version));
    }
    std::string plots;
    for (const Model model : richest_first(runs[0].measured)) {
        plots += fmt::format("<div>{}</div>\n", fronts_plot(words, runs, model));
    }
    return fmt::format("<header><p class=\"kicker\">{}</p><h1>{}</h1></header>\n", words.text("report.title"),
                       words.text("report.side_by_side")) +
           section("runs", words.text("report.runs"), words.text("report.runs.lead"), runs_table(words, runs)) +
           section("fronts", words.text("report.fronts"), words.text("report.fronts.lead"),
                   legend_html(words, names, false) + "<div class=\"plots\">" + plots + "</div>\n") +
           section("twins", words.text("report.twins"), words.text("report.twins.lead"), times_table(words, runs));
}

std::string heading(const ReportRun &run) {
    const Words &words = run.words;
    const WorkPrecision &m = run.measured;
    std::string text = fmt::format(R"(<header><p class="kicker">{}</p><h1>{}</h1>)", words.text("report.title"),
                                   escaped(file_text(words, m.scene.name)));
    if (!m.scene.description.empty()) {
        text += fmt::format(R"(<p class="lead">{}</p>)", escaped(file_text(words, m.scene.description)));
    }
    text += fmt::format(R"(<p class="facts">{} &middot; {} &middot; Shading Sandbox {} &middot; {} UTC</p>)",
                        words.format("report.pixels", m.options.size.width, m.options.size.height),
                        escaped(run.machine.renderer), escaped(run.version), escaped(run.date));
    if (!m.finished) {
        text += fmt::format("<p class=\"warning\">{}</p>", words.text("report.stopped"));
    }
    if (run.quick) {
        text += fmt::format("<p class=\"note\">{}</p>", words.format("report.quick", m.options.repeats));
    }
    return text + "</header>\n";
}

} // namespace

std::string report_html(const std::vector<ReportRun> &runs) {
    const Words words = runs.empty() ? words_in(languages.front()) : runs[0].words;
    std::string body = runs.size() > 1 ? comparison(words, runs) : "";
    for (const ReportRun &run : runs) {
        body += heading(run) + summary(run) + pictures(run) + error_against_time(run) + cheapest_rows(run) +
                order_ladder(run) + error_split(run) + certificates(run) + claims(run) + specialisation(run) +
                power(run) + precision(run) + all_rows(run) + method(run);
    }
    return page(words,
                runs.empty() ? words.text("report.report")
                             : words.format("report.of", file_text(words, runs[0].measured.scene.name)),
                body);
}

} // namespace sandbox

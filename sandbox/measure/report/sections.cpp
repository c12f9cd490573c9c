#include "measure/report/sections.h"

#include "measure/report/html.h"
#include "measure/report/text.h"
#include "words/row_words.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace sandbox::html {
namespace {

std::string cheapest_card(const Words &words, const WorkPrecision &m) {
    const Model model = models_of(m).back();
    const auto row = cheapest(m, model, ErrorNorm::rmse, error_bounds[0]);
    const std::string top = words.format("report.cheapest_card", title_of(words, model_key, static_cast<int>(model)));
    if (!row) {
        return card(top, words.text("report.none"), words.text("report.no_cheapest"));
    }
    const MeasuredRow &found = m.rows[*row];
    return card(top, escaped(to_string(found.plan.technique)),
                words.format("report.row", escaped(mesh_words(words, m.meshes[found.plan.mesh])),
                             milliseconds_text(found.time->median),
                             short_number(words, found.errors->total.norms.rmse)),
                true);
}

std::string saving_card(const Words &words, const WorkPrecision &m) {
    std::vector<double> ratios;
    for (const TimeRatio &ratio : ratios_to_base(m, RowGroup::full_program)) {
        ratios.push_back(ratio.median);
    }
    if (ratios.empty()) {
        return {};
    }
    const std::size_t count = ratios.size();
    return card(words.text("report.saving"),
                fmt::format("{} %", std::lround(100 * (1 - 1 / run_time(std::move(ratios)).median))),
                words.format("report.saving.of", count));
}

std::string truth_card(const Words &words, const WorkPrecision &m) {
    return card(words.text("report.judged"),
                words.text(m.no_analytic_surface.empty() ? "report.surfaces" : "report.finest"),
                words.text("report.judged.how"), true);
}

std::string failures_card(const Words &words, const WorkPrecision &m) {
    const auto failed = std::ranges::count_if(
        m.rows, [](const MeasuredRow &row) { return row.errors && row.errors->total.nonfinite_pixels > 0; });
    return card(words.text("report.failures"), fmt::format("{}", failed),
                words.format("report.of_rows", m.rows.size()));
}

/// Empty where there is no such row.
std::string marked_card(const Words &words, const WorkPrecision &m) {
    const std::size_t marked = marked_rows(m);
    return marked == 0 ? ""
                       : card(words.text("report.marked"), fmt::format("{}", marked),
                              words.format("report.marked.of", m.rows.size()));
}

/// The head of a quantity's column; its unit and meaning show when the mouse rests on it.
template <class T> void add_head(std::vector<std::string> &heads, const Words &words, const Quantity<T> &quantity) {
    if (!quantity.heading.empty()) {
        heads.push_back(
            fmt::format(R"(<span title="{}">{}</span>)",
                        words.format("report.unit", meaning_of(words, quantity), unit_title(words, quantity.unit)),
                        heading_of(words, quantity)));
    }
}

std::vector<std::string> row_heads(const Words &words) {
    std::vector<std::string> heads = heads_of(words, {"technique", "rings", "triangles"});
    for (const Quantity<RunTime> &time : run_time_quantities) {
        add_head(heads, words, time);
    }
    heads.push_back(words.text("report.column.middle_half"));
    for_each_metric(Metrics{}, [&](const auto &metric, const auto &) { add_head(heads, words, metric); });
    for (const ErrorPart &part : error_parts) {
        heads.push_back(heading_of(words, part));
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

void add_errors(Table &table, const Words &words, const RowErrors &errors) {
    for_each_metric(errors.total, [&](const auto &metric, const auto &measured) {
        if (!metric.heading.empty()) {
            const bool bad = errors.total.nonfinite_pixels > 0;
            const bool marked = !why_untrusted(errors.total).empty();
            table.number(metric.value(measured).value_or(0), quantity_text(words, metric, measured),
                         bad              ? "bad"
                         : marked         ? "unsettled"
                         : metric.whole() ? "q"
                                          : "");
        }
    });
    for (const ErrorPart &part : error_parts) {
        table.number(part.rmse(errors.split), short_number(words, part.rmse(errors.split)), "q");
    }
}

void add_row(Table &table, const Words &words, const WorkPrecision &m, const MeasuredRow &row) {
    const PlannedMesh &mesh = m.meshes[row.plan.mesh];
    table.begin_row();
    const std::string mark = row.errors ? why_untrusted(words, row.errors->total) : "";
    table.text(technique_code(row.plan.technique) +
                   (mark.empty() ? "" : fmt::format(R"(<br><span class="q">{}</span>)", escaped(mark))),
               mark.empty() ? "" : "bad");
    table.number(mesh.rings, mesh.ladder ? fmt::format("{}", mesh.rings) : words.text("report.own"));
    table.number(static_cast<double>(mesh.triangles), fmt::format("{}", mesh.triangles));
    if (!row.refused.empty()) {
        table.rest(words.format("report.refused", escaped(row.refused)), "q");
    } else if (!row.errors) {
        table.rest(words.text("report.not_measured"), "q");
    } else {
        add_time(table, row.time);
        add_errors(table, words, *row.errors);
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
                                        saving_card(run.words, m), truth_card(run.words, m),
                                        failures_card(run.words, m), marked_card(run.words, m));
}

std::string all_rows(const ReportRun &run) {
    Table table(row_heads(run.words));
    for (const MeasuredRow &row : run.measured.rows) {
        add_row(table, run.words, run.measured, row);
    }
    return section("rows", run.words.text("report.rows"), run.words.text("report.rows.lead"), table.html());
}

std::string method(const ReportRun &run) {
    const WorkPrecision &m = run.measured;
    const Machine &machine = run.machine;
    const Words &words = run.words;
    std::vector<std::string> omitted, spent;
    for (const OmittedRow &row : m.omitted) {
        const std::string reason = row.reason.starts_with(same_program)
                                       ? words.format("report.same_program", row.reason.substr(same_program.size()))
                                       : row.reason;
        omitted.push_back(words.format("page.fact", "<code>" + escaped(row.technique) + "</code>", escaped(reason)));
    }
    for (const Quantity<Accounting> &part : accounting_quantities) {
        spent.push_back(words.format("report.spent_part", part.value(m.seconds).value_or(0), heading_of(words, part)));
    }
    const auto line = [&](std::string_view key, const std::string &text) {
        return item(words.text(fmt::format("report.method.{}", key)), text);
    };
    const std::string list =
        line("renderer", fmt::format("{}, OpenGL {}", escaped(machine.renderer), escaped(machine.opengl))) +
        line("processor", words.format("report.threads", escaped(machine.processor), machine.threads)) +
        item("LP_NUM_THREADS",
             machine.llvmpipe_threads.empty() ? words.text("report.not_set") : escaped(machine.llvmpipe_threads)) +
        line("program", fmt::format("Shading Sandbox {}, {}", escaped(run.version), escaped(machine.build))) +
        line("clock", escaped(file_text(words, machine.clock))) +
        line("rounds", words.format("report.rounds", m.options.warm_ups, m.options.repeats)) +
        line("frame", words.text("report.frame")) +
        line("truth", m.no_analytic_surface.empty()
                          ? words.text("report.on_surfaces")
                          : words.format("report.on_finest", escaped(m.no_analytic_surface))) +
        line("ladder", words.format("report.ladder", m.options.first_rings, m.options.last_rings)) +
        line("left_out", fmt::format("{}", fmt::join(omitted, words.text("technique.and")))) +
        line("spent", fmt::format("{}", fmt::join(spent, words.text("list.comma")))) +
        line("files", words.text("report.files"));
    return section("method", words.text("report.method"), "", "<dl>" + list + "</dl>\n");
}

} // namespace sandbox::html

#include "measure/report/page.h"
#include "measure/report/text.h"

#include <algorithm>
#include <cmath>

namespace sandbox::report_page {
namespace {

std::vector<Model> richest_first(const WorkPrecision &m) {
    auto models = models_of(m);
    std::ranges::reverse(models);
    return models;
}

std::string order_text(const std::optional<double> &p) {
    if (!p) {
        return "&ndash;";
    }
    char text[16];
    std::snprintf(text, sizeof text, "%.2f", *p);
    return text;
}

std::string orders_text(const Orders &orders) {
    if (!orders.max && !orders.l2 && !orders.l1) {
        return "&ndash;";
    }
    return order_text(orders.max) + " / " + order_text(orders.l2) + " / " + order_text(orders.l1);
}

std::string settling_style(Settling settling) {
    return settling == Settling::settled ? "" : settling == Settling::settling ? "unsettled" : "q";
}

/// The steps of one model: a line a frequency and part, a column a step.
std::string order_table(const WorkPrecision &m, const std::vector<OrderStep> &all, Model model) {
    std::vector<const OrderStep *> steps;
    for (const OrderStep &step : all) {
        if (m.rows[step.fine].plan.technique.model == model) {
            steps.push_back(&step);
        }
    }
    HtmlTable table(std::string(name_of(model)) + ": max / L2 / L1");
    table.column("technique", false);
    table.column("error", false);
    std::vector<std::size_t> columns; // the finer mesh of each
    for (const OrderStep *step : steps) {
        const std::size_t fine = m.rows[step->fine].plan.mesh;
        if (std::ranges::find(columns, fine) == columns.end()) {
            columns.push_back(fine);
            table.column(std::to_string(m.meshes[m.rows[step->coarse].plan.mesh].rings) + " &rarr; " +
                         std::to_string(m.meshes[fine].rings));
        }
    }
    std::vector<Technique> techniques;
    for (const OrderStep *step : steps) {
        const Technique &technique = m.rows[step->fine].plan.technique;
        if (std::ranges::find(techniques, technique) == techniques.end()) {
            techniques.push_back(technique);
        }
    }
    for (const Technique &technique : techniques) {
        for (const bool whole : {true, false}) {
            if (!whole && technique.frequency == Frequency::per_pixel) {
                continue; // nothing but N and P is interpolated
            }
            table.begin_row();
            table.text(whole ? technique_html(technique) : "");
            table.text(whole ? "whole" : "interpolation", "q");
            for (const std::size_t column : columns) {
                const auto step = std::ranges::find_if(steps, [&](const OrderStep *s) {
                    return m.rows[s->fine].plan.mesh == column && m.rows[s->fine].plan.technique == technique;
                });
                if (step == steps.end()) {
                    table.text("");
                    continue;
                }
                const Orders &orders = whole ? (*step)->total : (*step)->interpolation;
                table.number(orders.l2.value_or(0), orders_text(orders), settling_style((*step)->settling));
            }
        }
    }
    return columns.empty() ? std::string() : table.html();
}

std::string two_lines(double upper, double lower) {
    return short_number(upper) + "<br><span class=\"q\">" + short_number(lower) + "</span>";
}

} // namespace

std::string order_ladder(const ReportRun &run) {
    const auto steps = convergence_orders(run.measured);
    std::string body;
    for (const Model model : richest_first(run.measured)) {
        body += order_table(run.measured, steps, model);
    }
    return section(
        "orders", "How fast the error falls as triangles halve",
        "The order p = log<sub>2</sub>(e<sub>h</sub> / e<sub>h/2</sub>) of each step up the ladder. "
        "Linear interpolation of something smooth gives 2 / 2 / 2, a kink (the terminator) 1 / 1.5 / 2, a "
        "jump (a hard cone) 0 / 0.5 / 1. <span class=\"q\"><i>Grey and slanted: not settled yet</i></span>, the "
        "step before differs by more than 0.25, as while a highlight is narrower than the triangles. "
        "&ldquo;Whole&rdquo; is the picture against the truth; &ldquo;interpolation&rdquo; the technique "
        "against per-pixel on the same mesh.",
        body.empty() ? body : ladder_plots(run) + body);
}

std::string cheapest_rows(const ReportRun &run) {
    const WorkPrecision &m = run.measured;
    HtmlTable table;
    table.column("model", false);
    table.column("error", false);
    for (const double bound : error_bounds) {
        table.column("at most " + bound_name(bound), false);
    }
    bool any = false;
    for (const Model model : richest_first(m)) {
        for (const ErrorNorm norm : error_norms) {
            table.begin_row();
            table.text(std::string(name_of(model)));
            table.text(std::string(name_of(norm)));
            for (const double bound : error_bounds) {
                const auto row = cheapest(m, model, norm, bound);
                any = any || row;
                table.text(row ? technique_html(m.rows[*row].plan.technique) + "<br><span class=\"q\">" +
                                     escaped(mesh_words(m.meshes[m.rows[*row].plan.mesh])) + ", " +
                                     milliseconds_text(m.rows[*row].time->median) + " ms</span>"
                               : "none",
                           row ? "" : "q");
            }
        }
    }
    return section(
        "cheapest", "The cheapest technique that is close enough",
        "Least median time among all rows whose error stays within the bound: a level of an 8-bit display, of "
        "a 10-bit one, and 1e-5.",
        any ? table.html() : std::string());
}

std::string specialisation(const ReportRun &run) {
    const WorkPrecision &m = run.measured;
    HtmlTable table;
    table.column("technique", false);
    table.column("specialised, ms");
    table.column("full, ms");
    table.column("full / specialised");
    table.column("time saved");
    for (const TimeRatio &ratio : ratios_to_base(m, RowGroup::full_program)) {
        table.begin_row();
        table.text(technique_html(m.rows[ratio.base].plan.technique));
        table.number(m.rows[ratio.base].time->median, milliseconds_text(m.rows[ratio.base].time->median));
        table.number(m.rows[ratio.row].time->median, milliseconds_text(m.rows[ratio.row].time->median));
        table.number(ratio.median, ratio_html(ratio));
        const double saved = 100 * (1 - 1 / ratio.median);
        table.number(saved, std::to_string(std::lround(saved)) + " %", ratio.lower_quartile > 1 ? "good" : "");
    }
    return section(
        "specialisation", "What leaving out saves",
        "A specialised program holds only what the scene needs; the full one can do every scene and branches "
        "on uniforms. On the scene's own mesh; the ratio is of each round's two times, with the middle half.",
        table.empty() ? std::string() : table.html());
}

std::string power(const ReportRun &run) {
    const WorkPrecision &m = run.measured;
    HtmlTable table;
    table.column("technique", false);
    table.column("RMSE of arithmetic");
    table.column("largest");
    table.column("with power=auto");
    table.column("largest");
    table.column("time / auto");
    for (const TimeRatio &ratio : ratios_to_base(m, RowGroup::power)) {
        const auto &row = m.rows[ratio.row];
        const auto &base = m.rows[ratio.base];
        if (!row.errors || !base.errors) {
            continue;
        }
        table.begin_row();
        table.text(technique_html(row.plan.technique));
        for (const auto *one : {&row, &base}) {
            const Norms &arithmetic = one->errors->split.arithmetic;
            table.number(arithmetic.rmse, short_number(arithmetic.rmse));
            table.number(arithmetic.max_abs, short_number(arithmetic.max_abs));
        }
        table.number(ratio.median, ratio_html(ratio));
    }
    return section("power", "Stable against textbook power",
                   "The error that float32 arithmetic alone adds, with f<sup>n</sup> by pow() and by the stable form. "
                   "power=auto is the textbook line below n = 1024 and the stable form from there; the one that equals "
                   "it has no row of its own.",
                   table.empty() ? std::string() : table.html());
}

std::string claims(const ReportRun &run) {
    const WorkPrecision &m = run.measured;
    HtmlTable table;
    table.column("it is said that", false);
    table.column("so compare, with", false);
    table.column("RMSE");
    table.column("largest");
    table.column("time ratio");
    table.column("here it gives", false);
    for (const Claim &claim : answer_claims(m)) {
        const MeasuredRow &row = m.rows[claim.row];
        const MeasuredRow &against = m.rows[claim.against];
        const Norms &one = row.errors->total.norms;
        const Norms &other = against.errors->total.norms;
        table.begin_row();
        table.text(escaped(claim.says));
        table.text(technique_html(row.plan.technique) + "<br><span class=\"q\">" +
                   technique_html(against.plan.technique) + "</span>");
        table.number(one.rmse, two_lines(one.rmse, other.rmse));
        table.number(one.max_abs, two_lines(one.max_abs, other.max_abs));
        table.number(claim.time.median, ratio_html(claim.time));
        table.text(escaped(claim.finding));
    }
    return section("claims", "What is said, and what is measured",
                   "Shortcuts that tutorials recommend, on the scene's own mesh. A time counts as different where the "
                   "middle half of the rounds agrees on it.",
                   table.empty() ? std::string() : table.html());
}

} // namespace sandbox::report_page

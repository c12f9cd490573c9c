#include "measure/report/tables.h"

#include "measure/report/figures.h"
#include "measure/report/html.h"
#include "measure/report/text.h"
#include "measure/work_precision/claims.h"
#include "words/row_words.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace sandbox::html {
namespace {

/// "2.00 / 1.98 / 2.01"
std::string orders_text(const Orders &orders) {
    std::string text;
    bool any = false;
    for (const Quantity<Orders> &order : order_quantities) {
        const auto value = order.value(orders);
        any = any || value;
        text += fmt::format("{}{}", text.empty() ? "" : " / ", value ? fmt::format("{:.2f}", *value) : "&ndash;");
    }
    return any ? text : "&ndash;";
}

std::string_view style_of(Settling settling) {
    return settling == Settling::settled ? "" : settling == Settling::settling ? "unsettled" : "q";
}

/// The steps of one model: a row per technique and kind of error, a column per step.
std::string order_table(const Words &words, const WorkPrecision &m, const std::vector<OrderStep> &all, Model model) {
    std::vector<const OrderStep *> steps;
    for (const OrderStep &step : all) {
        if (m.rows[step.fine].plan.technique.model == model) {
            steps.push_back(&step);
        }
    }
    std::vector<std::string> heads = heads_of(words, {"technique", "error"});
    std::vector<std::size_t> columns; // the finer mesh of each
    for (const OrderStep *step : steps) {
        const std::size_t fine = m.rows[step->fine].plan.mesh;
        if (std::ranges::find(columns, fine) == columns.end()) {
            columns.push_back(fine);
            const PlannedMesh &coarse = m.meshes[m.rows[step->coarse].plan.mesh];
            heads.push_back(fmt::format("{} &rarr; {}", coarse.rings, m.meshes[fine].rings));
        }
    }
    Table table(heads, words.format("report.orders_of", title_of(words, model_key, static_cast<int>(model))));
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
            table.text(whole ? technique_code(technique) : "");
            table.text(words.text(whole ? "report.whole" : "report.interpolation"), "q");
            for (const std::size_t column : columns) {
                const auto step = std::ranges::find_if(steps, [&](const OrderStep *s) {
                    return m.rows[s->fine].plan.mesh == column && m.rows[s->fine].plan.technique == technique;
                });
                if (step == steps.end()) {
                    table.text("");
                    continue;
                }
                const Orders &orders = whole ? (*step)->total : (*step)->interpolation;
                table.number(orders.l2.value_or(0), orders_text(orders), style_of((*step)->settling));
            }
        }
    }
    return table.html();
}

std::string two_lines(const Words &words, double upper, double lower) {
    return fmt::format(R"({}<br><span class="q">{}</span>)", short_number(words, upper), short_number(words, lower));
}

} // namespace

std::string order_ladder(const ReportRun &run) {
    const auto steps = convergence_orders(run.measured);
    std::string body;
    for (const Model model : richest_first(run.measured)) {
        body += order_table(run.words, run.measured, steps, model);
    }
    return section("orders", run.words.text("report.orders"), run.words.text("report.orders.lead"),
                   body.empty() ? body : ladder_plots(run) + body);
}

std::string cheapest_rows(const ReportRun &run) {
    const WorkPrecision &m = run.measured;
    std::vector<std::string> heads = heads_of(run.words, {"model", "error"});
    for (const double bound : error_bounds) {
        heads.push_back(run.words.format("report.at_most", bound_name(bound)));
    }
    Table table(heads);
    bool any = false;
    for (const Model model : richest_first(m)) {
        for (const ErrorNorm norm : error_norms) {
            table.begin_row();
            table.text(title_of(run.words, model_key, static_cast<int>(model)));
            table.text(title_of(run.words, norm));
            for (const double bound : error_bounds) {
                const auto row = cheapest(m, model, norm, bound);
                if (!row) {
                    table.text(run.words.text("report.none"), "q");
                    continue;
                }
                any = true;
                const MeasuredRow &found = m.rows[*row];
                const std::size_t ties = ties_of(m, *row, norm, bound).size();
                table.text(fmt::format(R"({}<br><span class="q">{}{}</span>)", technique_code(found.plan.technique),
                                       run.words.format("report.mesh_ms",
                                                        escaped(mesh_words(run.words, m.meshes[found.plan.mesh])),
                                                        milliseconds_text(found.time->median)),
                                       ties == 0   ? ""
                                       : ties == 1 ? run.words.text("report.one_tie")
                                                   : run.words.format("report.ties", ties)));
            }
        }
    }
    return section("cheapest", run.words.text("report.cheapest"), run.words.text("report.cheapest.lead"),
                   any ? table.html() : std::string());
}

/// Full, specialised, baked.
std::string specialisation(const ReportRun &run) {
    const WorkPrecision &m = run.measured;
    Table table(heads_of(run.words,
                         {"technique", "full_ms", "specialised_ms", "baked_ms", "full_ratio", "baked_ratio", "saved"}));
    const auto baked = ratios_to_base(m, RowGroup::baked_program);
    const auto median = [&](std::size_t row) {
        table.number(m.rows[row].time->median, milliseconds_text(m.rows[row].time->median));
    };
    for (const TimeRatio &full : ratios_to_base(m, RowGroup::full_program)) {
        const auto other = std::ranges::find(baked, full.base, &TimeRatio::base);
        table.begin_row();
        table.text(technique_code(m.rows[full.base].plan.technique));
        median(full.row);
        median(full.base);
        other != baked.end() ? median(other->row) : table.text("");
        table.number(full.median, ratio_text(full));
        other != baked.end() ? table.number(other->median, ratio_text(*other)) : table.text("");
        const double saved = 100 * (1 - 1 / full.median);
        table.number(saved, fmt::format("{} %", std::lround(saved)), full.lower_quartile > 1 ? "good" : "");
    }
    return section("specialisation", run.words.text("report.specialisation"),
                   run.words.text("report.specialisation.lead"), table.html());
}

std::string power(const ReportRun &run) {
    const WorkPrecision &m = run.measured;
    Table table(heads_of(run.words, {"technique", "arithmetic", "largest", "auto", "largest", "auto_ratio"}));
    for (const TimeRatio &times : ratios_to_base(m, RowGroup::power)) {
        const auto &row = m.rows[times.row];
        const auto &base = m.rows[times.base];
        if (!row.errors || !base.errors) {
            continue;
        }
        table.begin_row();
        table.text(technique_code(row.plan.technique));
        for (const auto *shown : {&row, &base}) {
            const Norms &arithmetic = shown->errors->split.arithmetic;
            table.number(arithmetic.rmse, short_number(run.words, arithmetic.rmse));
            table.number(arithmetic.max_abs, short_number(run.words, arithmetic.max_abs));
        }
        table.number(times.median, ratio_text(times));
    }
    return section("power", run.words.text("report.power"), run.words.text("report.power.lead"), table.html());
}

std::string certificates(const ReportRun &run) {
    const Words &words = run.words;
    std::vector<std::string> heads = heads_of(words, {"technique", "rings"});
    for (const Quantity<CertificateFigures> &quantity : certificate_quantities) {
        heads.push_back(heading_of(words, quantity));
    }
    Table table(heads);
    bool any = false;
    for (const MeasuredRow &row : run.measured.rows) {
        if (!row.certificate) {
            continue;
        }
        any = true;
        const PlannedMesh &mesh = run.measured.meshes[row.plan.mesh];
        table.begin_row();
        table.text(technique_code(row.plan.technique));
        table.number(mesh.rings, mesh.ladder ? fmt::format("{}", mesh.rings) : words.text("report.own"));
        for (const Quantity<CertificateFigures> &quantity : certificate_quantities) {
            table.number(quantity.value(*row.certificate).value_or(0),
                         quantity_text(words, quantity, *row.certificate));
        }
    }
    return section("certificates", words.text("report.certificates"), words.text("report.certificates.lead"),
                   any ? table.html() : std::string());
}

std::string precision(const ReportRun &run) {
    const Words &words = run.words;
    Table table(heads_of(words, {"technique", "rounded", "device", "stay_high", "left"}));
    const auto levels = [&](double value) {
        std::isfinite(value) ? table.number(value, fmt::format("{:.2f}", value))
                             : table.text(words.text("answer.not_finite"), "bad");
    };
    for (const PrecisionFinding &finding : run.measured.precision) {
        table.begin_row();
        table.text(technique_code(finding.technique));
        levels(finding.rounded);
        finding.device ? levels(*finding.device) : table.text("&ndash;", "q");
        table.text(finding.high.empty()
                       ? words.text("report.none")
                       : fmt::format("<code>{}</code>",
                                     escaped(fmt::format("{}", fmt::join(finding.high, words.text("list.comma"))))));
        levels(finding.left);
    }
    return section("precision", words.text("report.precision"), words.text("report.precision.lead"),
                   run.measured.precision.empty() ? std::string() : table.html());
}

std::string claims(const ReportRun &run) {
    const WorkPrecision &m = run.measured;
    Table table(heads_of(run.words, {"claim", "compared", "rmse", "largest", "time_ratio", "measured"}));
    for (const Claim &claim : answer_claims(run.words, m)) {
        const MeasuredRow &row = m.rows[claim.row];
        const MeasuredRow &against = m.rows[claim.against];
        const Norms &error = row.errors->total.norms;
        const Norms &other = against.errors->total.norms;
        table.begin_row();
        table.text(escaped(claim.says));
        table.text(fmt::format(R"({}<br><span class="q">{}</span>)", technique_code(row.plan.technique),
                               technique_code(against.plan.technique)));
        table.number(error.rmse, two_lines(run.words, error.rmse, other.rmse));
        table.number(error.max_abs, two_lines(run.words, error.max_abs, other.max_abs));
        table.number(claim.time.median, ratio_text(claim.time));
        table.text(escaped(claim.finding));
    }
    return section("claims", run.words.text("report.claims"), run.words.text("report.claims.lead"), table.html());
}

} // namespace sandbox::html

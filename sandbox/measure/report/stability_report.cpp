#include "measure/report/stability_report.h"

#include "measure/report/csv.h"
#include "measure/report/html.h"
#include "measure/report/text.h"
#include "words/row_words.h"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace sandbox {
namespace {

using nlohmann::ordered_json;

ordered_json row_json(const StabilityRow &row) {
    ordered_json json{{"technique", to_string(row.technique)}, {"passed", row.passed}, {"error", row.error}};
    if (!row.refused.empty()) {
        json["refused"] = row.refused;
    }
    for_each_metric(row.metrics, [&](const auto &metric, const auto &measured) {
        if (!metric.costly) {
            json[metric.name] = quantity_json<ordered_json>(metric, measured);
        }
    });
    return json;
}

ordered_json result_json(const Words &english, const StabilityResult &result) {
    const StabilityCase &judged = result.definition;
    const auto cost = result.cost_ratio();
    ordered_json rows = ordered_json::array();
    for (const StabilityRow &row : result.rows) {
        rows.push_back(row_json(row));
    }
    return {{"name", judged.name},
            {"group", judged.group},
            {"symptom", judged.symptom},
            {"cause", judged.cause},
            {"source", judged.source},
            {"seen_on", judged.seen_on.empty() ? ordered_json() : ordered_json(judged.seen_on)},
            {"bound", judged.bound},
            {"unit", name_of(judged.unit)},
            {"passed", result.passed()},
            {"cost", cost ? ordered_json(*cost) : ordered_json()},
            {"textbook_form", textbook_words(english, judged)},
            {"textbook_breaks", result.textbook_breaks()},
            {"textbook", row_json(result.textbook)},
            {"robust", rows}};
}

void add_csv_row(CsvTable &table, const StabilityResult &result, const StabilityRow &row, const char *form) {
    table.begin_row();
    table.cell("name", result.definition.name);
    table.cell("group", result.definition.group);
    table.cell("form", form);
    table.cell("technique", to_string(row.technique));
    table.cell("bound", result.definition.bound);
    table.cell("unit", name_of(result.definition.unit));
    table.cell("error", row.error);
    for_each_metric(row.metrics, [&](const auto &metric, const auto &measured) {
        if (!metric.costly) {
            table.cell(std::string(metric.name), metric, measured);
        }
    });
    table.cell("passed", !row.refused.empty() ? "refused: " + row.refused : row.passed ? "yes" : "no");
    if (const auto cost = result.cost_ratio(); cost && &row == &result.rows.front()) {
        table.cell("cost", *cost);
    }
}

std::string form_figure(const Words &words, std::string_view form, const StabilityRow &row, const ByteImage &image) {
    return html::figure(words.text(form), row.metrics.nonfinite_pixels > 0 ? "" : words.text("report.column.error"),
                        error_words(words, row), image);
}

std::string case_html(const Words &words, const StabilityResult &result) {
    const StabilityCase &judged = result.definition;
    const auto [style, verdict] =
        result.passed() ? std::pair("kept", "stability.page.kept") : std::pair("broken", "stability.page.broken");
    std::string story;
    for (const auto &[term, text] :
         {std::pair("stability.here", result.textbook_breaks() ? "" : seen_on_words(words, judged)),
          std::pair("stability.symptom", file_text(words, judged.symptom)),
          std::pair("stability.cause", file_text(words, judged.cause)),
          std::pair("stability.met_in", file_text(words, judged.source)),
          std::pair("stability.textbook_title", textbook_words(words, judged)),
          std::pair("stability.bound", bound_words(words, judged)),
          std::pair("stability.cost_title", cost_words(words, result))}) {
        story += text.empty() ? "" : fmt::format("<dt>{}</dt><dd>{}</dd>", words.text(term), html::escaped(text));
    }
    std::string warnings;
    for (const StabilityRow &row : result.rows) {
        if (!row.refused.empty()) {
            warnings += fmt::format("<p>{}</p>", words.format("stability.refused", html::technique_code(row.technique),
                                                              html::escaped(row.refused)));
        } else if (!row.passed) {
            warnings += fmt::format("<p class=\"warning\">{}</p>",
                                    words.format("stability.page.warning", html::technique_code(row.technique),
                                                 error_words(words, row), row.metrics.compared_pixels,
                                                 row.metrics.silhouette_pixels));
        }
    }
    return fmt::format(
        "<article class=\"case\" id=\"{0}\"><h3>{0}<span class=\"badge {1}\">{2}</span></h3>\n"
        "<div class=\"body\"><div class=\"three\">{3}{4}{5}</div><div><dl>{6}</dl>\n{7}</div></div></article>\n",
        html::escaped(judged.name), style, words.text(verdict),
        form_figure(words, "stability.textbook_title", result.textbook, result.textbook_image),
        form_figure(words, "stability.robust_title", result.rows.front(), result.robust_image),
        html::figure(words.text("stability.reference_title"), words.text("stability.in_double"), "",
                     result.reference_image),
        story, warnings);
}

using Results = std::vector<const StabilityResult *>;

/// Those whose textbook's form breaks, or the others.
Results list_of(const StabilityRun &run, bool breaks) {
    Results list;
    for (const StabilityResult &result : run.results) {
        if (result.textbook_breaks() == breaks) {
            list.push_back(&result);
        }
    }
    return list;
}

std::string title_of(const Words &words, std::string_view title, const Results &list) {
    return words.format("stability.list", words.text(title), list.size());
}

std::string table_html(const Words &words, const Results &list) {
    std::vector<std::string> heads;
    for (const char *head : {"case", "textbook_error", "nonfinite", "worst_error", "of_technique", "nonfinite", "bound",
                             "cost", "verdict"}) {
        heads.push_back(words.text(fmt::format("stability.column.{}", head)));
    }
    html::Table table(std::move(heads));
    const auto add_error = [&](const StabilityRow &row) { table.number(row.error, short_number(words, row.error)); };
    const auto add_nonfinite = [&](const StabilityRow &row) {
        const auto count = row.metrics.nonfinite_pixels;
        table.number(static_cast<double>(count), fmt::format("{}", count));
    };
    for (const StabilityResult *one : list) {
        const StabilityResult &result = *one;
        const StabilityRow &worst = result.worst();
        const auto cost = result.cost_ratio();
        table.begin_row();
        table.text(fmt::format("<a href=\"#{0}\">{0}</a>", html::escaped(result.definition.name)));
        add_error(result.textbook);
        add_nonfinite(result.textbook);
        add_error(worst);
        table.text(html::technique_code(worst.technique));
        add_nonfinite(worst);
        table.number(result.definition.bound, short_number(result.definition.bound));
        table.number(cost.value_or(0), cost ? short_number(*cost) : "");
        table.text(words.text(result.passed() ? "stability.page.within" : "stability.page.beyond"),
                   result.passed() ? "" : "bad");
    }
    return table.html();
}

/// The cases of one group after the other.
std::string group_sections(const Words &words, const Results &results) {
    std::string sections, body;
    for (std::size_t i = 0; i < results.size(); ++i) {
        const std::string &group = results[i]->definition.group;
        body += case_html(words, *results[i]);
        if (i + 1 == results.size() || results[i + 1]->definition.group != group) {
            const std::string title = html::escaped(file_text(words, group));
            const auto first = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
            sections += html::section(html::escaped(group), first + title.substr(1), "", body);
            body.clear();
        }
    }
    return sections;
}

/// A case's line of the terminal's table, and what there is to say of it.
std::string table_lines(const Words &words, const StabilityResult &result, std::size_t width) {
    const auto cost = result.cost_ratio();
    std::string out = fmt::format("{:<{}}{:<16}{:<16}{:<10}{:<7}{}\n", result.definition.name, width,
                                  error_words(words, result.textbook), error_words(words, result.worst()),
                                  short_number(result.definition.bound), cost ? short_number(*cost) : "",
                                  result.passed() ? "ok" : "BROKEN");
    if (!result.textbook_breaks() && !result.definition.seen_on.empty()) {
        out += fmt::format("    seen on: {}\n", result.definition.seen_on);
    }
    for (const StabilityRow &row : result.rows) {
        if (!row.refused.empty()) {
            out += fmt::format("    {}\n", words.format("stability.refused", to_string(row.technique), row.refused));
        } else if (!row.passed) {
            const Metrics &m = row.metrics;
            out += fmt::format("    {}: error {}, compared {}, silhouette {}, edge {}, jump {}, rounding {}\n",
                               to_string(row.technique), error_words(words, row), m.compared_pixels,
                               m.silhouette_pixels, m.edge_pixels, m.jump_pixels, m.rounding_pixels);
        }
    }
    return out;
}

} // namespace

std::string stability_html(const StabilityRun &run) {
    const Words &words = run.words;
    const auto kept = std::ranges::count_if(run.results, [](const StabilityResult &r) { return r.passed(); });
    const Results breaks = list_of(run, true), holds = list_of(run, false);
    const auto card = [&](auto count, std::string_view below) {
        return html::card("", words.format("stability.page.of", count, run.results.size()), words.text(below));
    };
    const std::string header = fmt::format(R"(<header><p class="kicker">{}</p><h1>{}</h1><p class="lead">{}</p>)"
                                           R"(<p class="facts">{} &middot; {} &middot; Shading Sandbox {}</p></header>)"
                                           "\n",
                                           words.text("stability.page.kicker"), words.text("stability.page"),
                                           words.text("stability.page.lead"),
                                           words.format("report.pixels", stability_size.width, stability_size.height),
                                           html::escaped(run.renderer), html::escaped(run.version));
    const std::string cards = card(kept, "stability.page.all_kept") +
                              card(breaks.size(), "stability.page.textbook_breaks") +
                              card(holds.size(), "stability.page.nothing_breaks");
    const auto table = [&](std::string_view title, const Results &list, std::string_view lead) {
        return html::section("table", title_of(words, title, list), words.text(lead), table_html(words, list));
    };
    std::string unbroken;
    for (const StabilityResult *result : holds) {
        unbroken += case_html(words, *result);
    }
    return html::page(
        words, words.text("stability.page"),
        header + "<div class=\"cards\">" + cards + "</div>\n" +
            table(breaks_title, breaks, "stability.page.breaks_lead") +
            table(holds_title, holds, "stability.page.holds_lead") + group_sections(words, breaks) +
            html::section("holds", words.text(holds_title), words.text("stability.page.elsewhere"), unbroken));
}

std::string stability_json(const StabilityRun &run) {
    ordered_json cases = ordered_json::array();
    for (const StabilityResult &result : run.results) {
        cases.push_back(result_json(run.words.english(), result));
    }
    const ordered_json all{{"format", "shading-sandbox stability 1"},
                           {"version", run.version},
                           {"renderer", run.renderer},
                           {"size", {stability_size.width, stability_size.height}},
                           {"textbook_breaks", list_of(run, true).size()},
                           {"nothing_breaks", list_of(run, false).size()},
                           {"cases", cases}};
    return all.dump(2) + "\n";
}

std::string stability_csv(const StabilityRun &run) {
    CsvTable table;
    for (const StabilityResult &result : run.results) {
        add_csv_row(table, result, result.textbook, "textbook");
        for (const StabilityRow &row : result.rows) {
            add_csv_row(table, result, row, "robust");
        }
    }
    return table.text();
}

std::string stability_table(const StabilityRun &run) {
    std::size_t widest = 4;
    for (const StabilityResult &result : run.results) {
        widest = std::max(widest, result.definition.name.size());
    }
    std::string out =
        fmt::format("{:<{}}{:<16}{:<16}{:<10}{:<7}\n", "case", widest + 2, "textbook", "robust", "bound", "cost");
    for (const bool breaks : {true, false}) {
        const Results list = list_of(run, breaks);
        out += list.empty() ? "" : title_of(run.words.english(), breaks ? breaks_title : holds_title, list) + "\n";
        for (const StabilityResult *result : list) {
            out += table_lines(run.words.english(), *result, widest + 2);
        }
    }
    return out;
}

std::string textbook_words(const Words &words, const StabilityCase &judged) {
    const std::string form =
        judged.textbook ? words.format("stability.renderers", to_string(*judged.textbook))
                        : words.format("stability.processors",
                                       title_of(words, frequency_key, frequency_key.get(judged.techniques.front())));
    return judged.textbook_target == TextbookTarget::half ? words.format("stability.in_half", form) : form;
}

std::string seen_on_words(const Words &words, const StabilityCase &judged) {
    return judged.seen_on.empty() ? words.text("stability.unbroken")
                                  : words.format("stability.seen_on", file_text(words, judged.seen_on));
}

std::string bound_words(const Words &words, const StabilityCase &judged) {
    const std::string bound = short_number(judged.bound);
    return judged.unit == ErrorUnit::linear_color ? bound : words.format("stability.of_brightest", bound);
}

std::string cost_words(const Words &words, const StabilityResult &result) {
    if (!result.guarded) {
        return words.text("stability.no_cost");
    }
    return result.cost ? words.format("stability.cost", short_number(*result.cost)) : "";
}

std::string error_words(const Words &words, const StabilityRow &row) {
    const auto bad = row.metrics.nonfinite_pixels;
    return bad > 0 ? words.format("stability.not_finite", bad) : short_number(row.error);
}

} // namespace sandbox

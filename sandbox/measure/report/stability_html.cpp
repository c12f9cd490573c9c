#include "image/image_file.h"
#include "measure/report/page.h"
#include "measure/report/text.h"
#include "measure/stability/stability.h"

#include <algorithm>

namespace sandbox {
namespace {

using namespace report_page;

// Beside the report's own style: a badge, a case's head, pictures in threes.
const char *const case_style = R"(
.case { background: var(--card); border: 1px solid var(--rule); border-radius: 8px; padding: 16px 18px; margin: 18px 0; }
.case h3 { margin: 0 0 8px; display: flex; align-items: baseline; gap: 12px; flex-wrap: wrap; }
.badge { font-size: 0.8rem; font-weight: 600; padding: 1px 9px; border-radius: 99px; border: 1px solid currentColor; }
.badge.kept { color: var(--accent); } .badge.broken { color: var(--warn); background: var(--warn-page); }
.case .body { display: grid; grid-template-columns: minmax(300px, 5fr) 6fr; gap: 22px; }
.case .three { display: grid; grid-template-columns: repeat(3, minmax(0, 1fr)); gap: 10px; align-content: start; }
td a { white-space: nowrap; }
.case .three img { image-rendering: pixelated; }
.case dl { grid-template-columns: max-content 1fr; margin: 0; align-content: start; }
@media (max-width: 820px) { .case .body { grid-template-columns: 1fr; } }
)";

std::string error_words(const StabilityRow &row) {
    const auto bad = row.metrics.nonfinite_pixels;
    return bad > 0 ? std::to_string(bad) + (bad == 1 ? " pixel" : " pixels") + " not finite" : short_number(row.error);
}

std::string picture(const char *title, const std::string &caption, const ByteImage &image) {
    return std::string("<figure><img alt=\"") + title + "\" src=\"data:image/png;base64," + base64(encode_png(image)) +
           "\"><figcaption><b>" + title + "</b>" + caption + "</figcaption></figure>";
}

std::string case_html(const StabilityResult &result) {
    const StabilityCase &of = result.of;
    std::string html = "<article class=\"case\" id=\"" + of.name + "\"><h3>" + of.name + "<span class=\"badge " +
                       (result.passed() ? "kept\">within its bound" : "broken\">bound broken") +
                       "</span></h3>\n<div class=\"body\"><div class=\"three\">";
    html += picture("Textbook", "error " + error_words(result.textbook), result.textbook_image);
    html += picture("Robust", "error " + error_words(result.rows.front()), result.robust_image);
    html += picture("Reference", "in double", result.reference_image);
    html += "</div><div><dl><dt>Symptom</dt><dd>" + escaped(of.symptom) + "</dd><dt>Cause</dt><dd>" +
            escaped(of.cause) + "</dd><dt>Met in</dt><dd>" + escaped(of.source) + "</dd><dt>Bound</dt><dd>" +
            bound_words(of) + "</dd>";
    if (result.cost) {
        html += "<dt>Cost</dt><dd>" + cost_words(*result.cost) + "</dd>";
    }
    html += "</dl>\n";
    for (const StabilityRow &row : result.rows) {
        if (!row.passed) {
            html += "<p class=\"warning\">" + technique_html(row.technique) + ": " + error_words(row) + "; " +
                    std::to_string(row.metrics.compared_pixels) + " pixels compared, " +
                    std::to_string(row.metrics.silhouette_pixels) + " show another object</p>";
        }
    }
    return html + "</div></div></article>\n";
}

std::string table_html(const StabilityRun &run) {
    HtmlTable table;
    table.column("case", false);
    table.column("textbook's error");
    table.column("not finite");
    table.column("robust error, worst");
    table.column("of technique", false);
    table.column("not finite");
    table.column("bound");
    table.column("cost");
    table.column("verdict", false);
    for (const StabilityResult &result : run.results) {
        const StabilityRow &worst = result.worst();
        table.begin_row();
        table.text("<a href=\"#" + result.of.name + "\">" + result.of.name + "</a>");
        table.number(result.textbook.error, short_number(result.textbook.error));
        table.number(static_cast<double>(result.textbook.metrics.nonfinite_pixels),
                     std::to_string(result.textbook.metrics.nonfinite_pixels));
        table.number(worst.error, short_number(worst.error));
        table.text(technique_html(worst.technique));
        table.number(static_cast<double>(worst.metrics.nonfinite_pixels),
                     std::to_string(worst.metrics.nonfinite_pixels));
        table.number(result.of.bound, short_number(result.of.bound));
        table.number(result.cost.value_or(0), result.cost ? short_number(*result.cost) : "");
        table.text(result.passed() ? "within" : "broken", result.passed() ? "" : "bad");
    }
    return table.html();
}

} // namespace

std::string stability_html(const StabilityRun &run) {
    const auto broken = std::ranges::count_if(run.results, [](const StabilityResult &r) { return !r.passed(); });
    const auto naive = std::ranges::count_if(run.results, [](const StabilityResult &r) { return !r.textbook.passed; });
    const std::string count = std::to_string(run.results.size());
    std::string html =
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<meta name=\"color-scheme\" content=\"light dark\">\n<title>Stiff and extreme cases</title>\n<style>\n";
    html +=
        std::string(style) + case_style +
        "</style>\n</head>\n<body>\n<main>\n<header><p class=\"kicker\">Numerical "
        "stability</p><h1>Stiff and extreme cases</h1><p class=\"lead\">Scenes on which a textbook's float32 formulas "
        "break: drawn, and judged against the same equation in double.</p><p class=\"facts\">" +
        std::to_string(stability_size.width) + " &times; " + std::to_string(stability_size.height) +
        " pixels &middot; " + escaped(run.renderer) + " &middot; Shading Sandbox " + escaped(run.version) +
        "</p></header>\n<div class=\"cards\"><div class=\"card\"><b>" +
        std::to_string(run.results.size() - static_cast<std::size_t>(broken)) + " of " + count +
        "</b><span>within their bound as this program draws them</span></div><div class=\"card\"><b>" +
        std::to_string(naive) + " of " + count + "</b><span>out of bound in the textbook's form</span></div></div>\n";
    html +=
        section("table", "All cases",
                "A case keeps its bound if every pixel is finite and the largest difference over the compared pixels "
                "stays within it, for every technique of the case. Cost is run time over that of the same program "
                "without guards and stable powers, taken in turns; 1 where the scene needs none.",
                table_html(run));
    std::string group, body;
    for (std::size_t i = 0; i < run.results.size(); ++i) {
        const StabilityResult &result = run.results[i];
        group = result.of.group;
        body += case_html(result);
        if (i + 1 == run.results.size() || run.results[i + 1].of.group != group) {
            html += section(group, static_cast<char>(std::toupper(group[0])) + group.substr(1), "", body);
            body.clear();
        }
    }
    return html + "</main>\n<script>\n" + script + "</script>\n</body>\n</html>\n";
}

} // namespace sandbox

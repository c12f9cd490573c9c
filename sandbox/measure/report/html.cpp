#include "measure/report/report.h"

#include "measure/report/page.h"
#include "measure/report/text.h"

namespace sandbox {
namespace {

using namespace report_page;

std::string run_html(const ReportRun &run) {
    return summary(run) + pictures(run) + error_against_time(run) + cheapest_rows(run) + order_ladder(run) +
           error_split(run) + claims(run) + specialisation(run) + power(run) + all_rows(run) + method(run);
}

std::string heading(const ReportRun &run) {
    const WorkPrecision &m = run.measured;
    std::string html = "<header><p class=\"kicker\">Error against run time</p><h1>" + escaped(m.scene.name) + "</h1>";
    html += m.scene.description.empty() ? "" : "<p class=\"lead\">" + escaped(m.scene.description) + "</p>";
    html += "<p class=\"facts\">" + std::to_string(m.options.size.width) + " &times; " +
            std::to_string(m.options.size.height) + " pixels &middot; " + escaped(run.machine.renderer) +
            " &middot; Shading Sandbox " + escaped(run.version) + " &middot; " + escaped(run.date) + " UTC</p>";
    if (!m.finished) {
        html += "<p class=\"warning\">Incomplete: the measuring was stopped. What had been measured is here.</p>";
    }
    if (run.quick) {
        html += "<p class=\"note\">A quick overview: " + std::to_string(m.options.repeats) +
                " timed rounds. For figures to quote, run the report without --quick.</p>";
    }
    return html + "</header>\n";
}

} // namespace

std::string report_html(const std::vector<ReportRun> &runs) {
    std::string title = runs.empty() ? "Report" : escaped(runs[0].measured.scene.name) + ": error against run time";
    std::string html = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                       "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
                       "<meta name=\"color-scheme\" content=\"light dark\">\n<title>" +
                       title + "</title>\n<style>\n" + style + "</style>\n</head>\n<body>\n<main>\n";
    if (runs.size() > 1) {
        html += comparison(runs);
    }
    for (const ReportRun &run : runs) {
        html += heading(run) + run_html(run);
    }
    return html + "</main>\n<script>\n" + script + "</script>\n</body>\n</html>\n";
}

} // namespace sandbox

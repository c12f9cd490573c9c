#include "measure/report/page.h"
#include "measure/report/text.h"

#include <cmath>
#include <cstdio>

namespace sandbox::report_page {
namespace {

std::string printed(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f", value);
    return text;
}

} // namespace

void HtmlTable::column(const std::string &head, bool number) {
    head_ += std::string("<th") + (number ? " class=\"n\"" : "") + ">" + head + "</th>";
}

void HtmlTable::text(const std::string &text, const std::string &style) {
    body_ += "<td" + (style.empty() ? "" : " class=\"" + style + "\"") + ">" + text + "</td>";
}

void HtmlTable::number(double value, const std::string &html, const std::string &style) {
    char key[40];
    std::snprintf(key, sizeof key, "%.9g", std::isfinite(value) ? value : 1e300);
    body_ += "<td class=\"n" + (style.empty() ? "" : " " + style) + "\" data-v=\"" + key + "\">" + html + "</td>";
}

std::string HtmlTable::html() const {
    return "<div class=\"scroll\"><table>" + (caption_.empty() ? "" : "<caption>" + caption_ + "</caption>") +
           "<thead><tr>" + head_ + "</tr></thead>\n<tbody>" + body_ + "</tr></tbody></table></div>\n";
}

std::string section(const std::string &id, const std::string &title, const std::string &lead, const std::string &body) {
    return body.empty()
               ? std::string()
               : "<section class=\"" + id + "\"><h2>" + title + "</h2>\n<p>" + lead + "</p>\n" + body + "</section>\n";
}

std::string technique_html(const Technique &technique) { return "<code>" + escaped(to_string(technique)) + "</code>"; }

std::string ratio_html(const TimeRatio &ratio) {
    return printed(ratio.median) + " <span class=\"q\">[" + printed(ratio.lower_quartile) + ", " +
           printed(ratio.upper_quartile) + "]</span>";
}

} // namespace sandbox::report_page

#pragma once

#include "measure/report/report.h"
#include "measure/work_precision/findings.h"

#include <string>
#include <vector>

/// The sections of report.html, each a piece of HTML; empty where a run has nothing to show.
namespace sandbox::report_page {

/// A table whose columns sort when their heads are clicked, where scripts run.
class HtmlTable {
  public:
    explicit HtmlTable(std::string caption = {}) : caption_(std::move(caption)) {}
    /// A column of text, or of numbers (to the right).
    void column(const std::string &head, bool number = true);
    void begin_row() { body_ += body_.empty() ? "<tr>" : "</tr>\n<tr>"; }
    void text(const std::string &text, const std::string &style = {});
    /// HTML that is shown, and the number that it sorts by.
    void number(double value, const std::string &html, const std::string &style = {});
    [[nodiscard]] bool empty() const { return body_.empty(); }
    [[nodiscard]] std::string html() const;

  private:
    std::string caption_, head_, body_;
};

std::string section(const std::string &id, const std::string &title, const std::string &lead, const std::string &body);
std::string technique_html(const Technique &technique);
/// "1.23 [1.20, 1.31]"
std::string ratio_html(const TimeRatio &ratio);

std::string summary(const ReportRun &run);
std::string pictures(const ReportRun &run);
std::string error_against_time(const ReportRun &run);
std::string cheapest_rows(const ReportRun &run);
/// A plot a model of the error against the rungs of the ladder.
std::string ladder_plots(const ReportRun &run);
std::string order_ladder(const ReportRun &run);
std::string error_split(const ReportRun &run);
std::string specialisation(const ReportRun &run);
std::string power(const ReportRun &run);
std::string claims(const ReportRun &run);
std::string all_rows(const ReportRun &run);
std::string method(const ReportRun &run);
/// Several runs beside each other.
std::string comparison(const std::vector<ReportRun> &runs);

extern const char *const style;
extern const char *const script;

} // namespace sandbox::report_page

#pragma once

#include "measure/report/report.h"

#include <string>

/// The sections of report.html that need no drawing; each is HTML, empty where a run has nothing to show.
namespace sandbox::html {

/// What a reader should know first, on cards.
std::string summary(const ReportRun &run);
/// Every row with all its numbers.
std::string all_rows(const ReportRun &run);
/// Where and how the numbers were taken.
std::string method(const ReportRun &run);

} // namespace sandbox::html

#pragma once

#include "measure/report/report.h"

#include <string>

/// The sections of report.html that are pictures and plots; each is HTML, empty where a run has nothing to show.
namespace sandbox::html {

std::string pictures(const ReportRun &run);
std::string error_against_time(const ReportRun &run);
/// One plot per model: the error over the rungs of the ladder.
std::string ladder_plots(const ReportRun &run);
std::string error_split(const ReportRun &run);

} // namespace sandbox::html

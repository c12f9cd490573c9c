#pragma once

#include "measure/report/report.h"

#include <string>

/// The sections of report.html that are tables of findings; each is HTML, empty where a run has nothing to show.
namespace sandbox::html {

std::string cheapest_rows(const ReportRun &run);
/// How fast errors fall from rung to rung of the ladder.
std::string order_ladder(const ReportRun &run);
std::string specialisation(const ReportRun &run);
std::string power(const ReportRun &run);
/// What the frequency auto promised and kept, mesh by mesh.
std::string certificates(const ReportRun &run);
/// What half precision changes, and which values must stay high.
std::string precision(const ReportRun &run);
std::string claims(const ReportRun &run);

} // namespace sandbox::html

#pragma once

#include "measure/report/report.h"
#include "measure/report/stability_report.h"

#include <filesystem>
#include <string>

/// What the commands `report` and `stability` write, in a new folder NAME-001, or the first number that is free, where
/// captures go. Both return the folder, absolute, and throw InputError.
namespace sandbox {

/// report.html, report.json and report.csv in `name`-report-001.
std::filesystem::path export_report(const ReportRun &run, const std::string &name);

/// stability.html, stability.json and stability.csv in stability-001.
std::filesystem::path export_stability(const StabilityRun &run);

} // namespace sandbox

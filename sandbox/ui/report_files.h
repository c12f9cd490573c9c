#pragma once

#include "measure/report.h"

#include <filesystem>
#include <string>

namespace sandbox {

/// Writes report.html, report.json and report.csv into a new folder `name`-report-001, or the first number that is
/// free, where captures go. Returns it, absolute. Throws InputError.
std::filesystem::path write_report(const ReportRun &run, const std::string &name);

} // namespace sandbox

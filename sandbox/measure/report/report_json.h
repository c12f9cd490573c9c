#pragma once

#include "measure/report/report.h"

#include <string>
#include <string_view>
#include <vector>

namespace sandbox {

/// {"format": ..., "runs": [...]}; the keys are documented in report_json.cpp.
std::string report_json(const std::vector<ReportRun> &runs);
/// The runs of a report.json, without their pictures. `name` is used in messages. Throws InputError.
std::vector<ReportRun> read_report_json(std::string_view text, std::string_view name);

} // namespace sandbox

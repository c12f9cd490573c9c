#pragma once

#include "measure/report/report.h"

#include <string>
#include <vector>

namespace sandbox {

/// One line a row, with a header; everything else that the report says of a row stands in its columns.
std::string report_csv(const std::vector<ReportRun> &runs);

} // namespace sandbox

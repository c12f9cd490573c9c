#pragma once

#include "measure/report/report.h"

#include <string>
#include <vector>

namespace sandbox {

/// One self-contained page. With several runs they stand side by side.
std::string report_html(const std::vector<ReportRun> &runs);

} // namespace sandbox

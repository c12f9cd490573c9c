#pragma once

#include "measure/report/report.h"

#include <vector>

namespace sandbox {

/// The truth, the best and the worst row of the ladder (least and largest RMSE) of the last model that was measured,
/// drawn once more.
std::vector<ReportPicture> report_pictures(const WorkPrecision &measured, const DrawRows &draw);

} // namespace sandbox

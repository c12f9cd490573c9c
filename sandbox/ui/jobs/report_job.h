#pragma once

#include "measure/report/report.h"
#include "ui/jobs/drawing_job.h"

#include <memory>

namespace sandbox {

using ReportJob = DrawingJob<ReportRun>;

/// Starts to measure `scene`, as the command `report` would. Throws MachineError (see Context::make_worker).
std::unique_ptr<ReportJob> start_report(const DrawingSupplies &supplies, const Scene &scene, bool quick);

} // namespace sandbox

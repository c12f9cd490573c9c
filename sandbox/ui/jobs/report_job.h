#pragma once

#include "measure/report/report.h"
#include "ui/jobs/drawing_job.h"

#include <memory>
#include <string>

namespace sandbox {

using ReportJob = DrawingJob<ReportRun>;

/// Starts to measure `scene`, as the command `report` would. Throws MachineError (see Context::make_worker).
std::unique_ptr<ReportJob> start_report(const DrawingSupplies &supplies, const Scene &scene, bool quick);

/// What a quick run of a scene would take on this machine, in seconds.
struct RunCost {
    double compiling = 0, drawing = 0, judging = 0;
    /// Of a whole run; a full one has more meshes, larger pictures and more rounds.
    [[nodiscard]] double seconds(bool quick) const;
};
using CostJob = DrawingJob<RunCost>;

/// Draws and judges a few rows of the quick plan. Throws MachineError (see Context::make_worker).
std::unique_ptr<CostJob> start_estimate(const DrawingSupplies &supplies, const Scene &scene);

/// "about 40 s", "about 12 min"; at least 5 s.
std::string about_seconds(double seconds);

} // namespace sandbox

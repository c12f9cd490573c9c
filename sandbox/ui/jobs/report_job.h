#pragma once

#include "measure/report/report.h"
#include "ui/jobs/drawing_job.h"

#include <memory>
#include <string>

namespace sandbox {

using ReportJob = DrawingJob<ReportRun>;

/// Starts to measure `scene`, as the command `report` would. Throws MachineError (see
/// BackgroundRenderer::make_context).
std::unique_ptr<ReportJob> start_report(const DrawingSupplies &supplies, const Scene &scene, bool quick,
                                        const Words &words);

/// How many seconds that would take on this machine, from a few of its rows: about a twentieth of them. Throws
/// MachineError (see BackgroundRenderer::make_context).
using CostJob = DrawingJob<double>;
std::unique_ptr<CostJob> start_estimate(const DrawingSupplies &supplies, const Scene &scene, bool quick);

/// "takes about 40 s", "takes about 12 min"; at least 5 s.
std::string about_seconds(const Words &words, double seconds);

} // namespace sandbox

#pragma once

#include "ui/jobs/drawing_job.h"
#include "ui/session/findings.h"

#include <functional>

namespace sandbox {

/// Of both pictures against their truths: first an estimate, then at the view's own size; `publish` is called after
/// each. Throws Cancelled.
void find_errors(const SidesShown &shown, DrawingTurn &turn, JobReporter &reporter,
                 const std::function<void(const Findings &)> &publish);
/// Adds the run times to what find_errors() has found; false if the reporter was cancelled.
bool find_times(Findings &findings, DrawingTurn &turn, JobReporter &reporter);

} // namespace sandbox

#pragma once

#include "render/renderer.h"
#include "ui/jobs/background_job.h"
#include "ui/session/findings.h"

#include <functional>

namespace sandbox {

/// Of both pictures against their truths: first an estimate, then at the view's own size; `publish` is called after
/// each. Ends early, with nothing more published, once the reporter is cancelled.
void find_errors(const SidesShown &shown, Renderer &renderer, JobReporter &reporter,
                 const std::function<void(const Findings &)> &publish);
/// Adds the run times to what find_errors() has found; false if the reporter was cancelled.
bool find_times(Findings &findings, Renderer &renderer, JobReporter &reporter);

} // namespace sandbox

#pragma once

#include "render/renderer.h"
#include "ui/jobs/background_job.h"
#include "ui/session/findings.h"

#include <functional>

namespace sandbox {

/// First an estimate, then the view's own size, then run times: `publish` is called after each step that can be shown.
/// Ends early, with nothing more published, once the reporter is cancelled.
void find_out(const SidesShown &shown, Renderer &renderer, JobReporter &reporter,
              const std::function<void(const Findings &)> &publish);

} // namespace sandbox

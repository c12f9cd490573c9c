#pragma once

#include "ui/jobs/background_job.h"
#include "ui/session/session.h"

namespace sandbox {

/// One row in the current ImGui window: "Cancel", how far the job is, what it is at.
void job_progress_row(Session &session, BackgroundJob &job);

} // namespace sandbox

#pragma once

#include "ui/jobs/motion_job.h"

namespace sandbox {

/// The changes over a round as curves that fill the current ImGui window, with the moment shown. A click shows another.
void motion_strip(Session &session, const Changes &changes);

} // namespace sandbox

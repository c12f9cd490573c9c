#pragma once

#include "ui/session/session.h"

namespace sandbox {

/// Frequencies, models and variants of A and B.
void technique_panel(Session &session);
void faults_panel(Session &session);

} // namespace sandbox

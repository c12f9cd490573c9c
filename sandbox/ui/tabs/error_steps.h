#pragma once

#include "ui/session/session.h"

#include <vector>

namespace sandbox {

/// A bar for each text that was marked, the last one last: as high as its largest error on a scale from 1 down to a
/// thousandth, a quarter of what a screen can show. Infinite: not finite; 0: none was found.
void error_steps(Session &session, const std::vector<double> &errors);

} // namespace sandbox

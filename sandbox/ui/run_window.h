#pragma once

#include "ui/window.h"

namespace sandbox {

/// Opens the window and returns when it is closed, with the process's exit code (0).
/// Throws MachineError if there is no display or no OpenGL 3.3.
int run_window(const WindowOptions &options);

} // namespace sandbox

#pragma once

#include "ui/window.h"

#include <filesystem>
#include <string>

namespace sandbox {

/// Works the window by the script in `file`, without a display. Returns the process's exit code: 1 where an `expect`
/// was not met, which stderr says. Throws InputError "FILE:LINE: ..." for a line that makes no sense or names a widget
/// that is not there, MachineError where there is no OpenGL 3.3.
int run_script(const std::filesystem::path &file, const WindowOptions &options);

/// What a script may say: a line for each action.
std::string script_help();

} // namespace sandbox

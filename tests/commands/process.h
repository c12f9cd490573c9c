#pragma once

#include "tools/temporary_folder.h"

#include <string>
#include <vector>

namespace sandbox {

using Arguments = std::vector<std::string>;

struct ProcessResult {
    int exit_code = -1; ///< -1: ended by a signal
    std::string out, err;
};

/// Runs the program with `arguments` and waits. `setup` goes before it on the shell's line, e.g. "env -u DISPLAY";
/// `redirect` after it, e.g. "< lines".
ProcessResult run_sandbox(const Arguments &arguments, const std::string &setup = {}, const std::string &redirect = {});

} // namespace sandbox

#pragma once

namespace sandbox {

/// From here on SIGINT (Ctrl-C) and SIGTERM end the process with 130, but never between a temporary file and its final
/// name; a write to a closed pipe, or beyond a limit on the size of files, fails instead of killing.
void handle_interrupts();

} // namespace sandbox

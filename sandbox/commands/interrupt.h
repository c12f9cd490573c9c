#pragma once

#include <filesystem>
#include <string_view>

/// Ctrl-C: ends at once with exit code 130, but never between a temporary file and its final name.
namespace sandbox {

/// From here on SIGINT and SIGTERM end the process with 130; a write to a closed pipe fails instead of killing.
void handle_interrupts();

/// write_file() that an interrupt waits for. Throws InputError naming the path.
void write_output(const std::filesystem::path &path, std::string_view bytes);

} // namespace sandbox

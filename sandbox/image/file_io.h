#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace sandbox {

/// The whole file. Throws InputError naming it.
std::string read_file(const std::filesystem::path &path);
/// Writes to a temporary name beside `path` and renames: whole or not at all. Throws InputError naming the path.
void write_file(const std::filesystem::path &path, std::string_view bytes);

} // namespace sandbox

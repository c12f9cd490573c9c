#pragma once

#include <filesystem>
#include <string>

/// What the user's desktop can do for the window.
namespace sandbox {

/// Is there such a program on the PATH?
bool is_installed(const std::string &program);
/// Shows a folder or a file in the program that the desktop has for it. Returns at once; throws InputError if there is
/// none.
void open_on_desktop(const std::filesystem::path &path);

} // namespace sandbox

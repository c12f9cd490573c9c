#pragma once

#include "scene/assets.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// Lessons and exercises as they are named: by a built-in name or a .json file.
namespace sandbox {

/// What a .json file holds, perhaps a bad one; none: a scene, or no such file.
enum class TaughtFile { none, lesson, exercise };
TaughtFile taught_file(const std::filesystem::path &file);

/// Is it the path of a file, not a built-in name?
bool names_file(const std::filesystem::path &name_or_file);

/// The built-in file of that name in one of the folders ("lessons/"). Throws InputError that calls it `what` and names
/// the nearest there is.
std::string builtin_file(const std::string &name, const std::vector<std::string_view> &folders, const Assets &assets,
                         std::string_view what);

} // namespace sandbox

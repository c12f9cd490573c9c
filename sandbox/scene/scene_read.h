#pragma once

#include "scene/scene_json.h"

#include <filesystem>

namespace sandbox {

/// JSON to Scene, checked by the format's table; `name` is used in messages. Relative paths are resolved against
/// `folder` by resolve_path(). Throws InputError.
Scene read_scene(const Json &json, std::string_view name, const std::filesystem::path &folder);

/// The path as text. Throws InputError if it is not UTF-8.
std::string checked_path(const std::filesystem::path &path);

/// The path made absolute and checked; a bare name that is no file in `folder` stays bare, because it may be a built-in
/// one.
std::string resolve_path(const std::string &path, const std::filesystem::path &folder);

/// The other way round: an absolute path as a file in `folder` says it, so that it holds when both are moved: relative,
/// with a "/", unless the two have nothing but the root in common. Other paths stay.
std::string path_from(const std::string &path, const std::filesystem::path &folder);

} // namespace sandbox

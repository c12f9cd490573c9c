#pragma once

#include "scene/scene.h"

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

/// The steps between a scene's text and a Scene: inside this room's scene_*.cpp files only.
namespace sandbox {

using Json = nlohmann::json;
using OrderedJson = nlohmann::ordered_json; ///< keeps the format's order of keys

/// Text to JSON. Throws InputError: `name:line:column: ...`; refuses keys given twice, deep nesting, 16 MiB and more.
Json parse_json(std::string_view text, std::string_view name);

/// JSON to text: two-space indent, whatever fits on a line on one line, whole numbers without ".0".
std::string print_json(const OrderedJson &json);

/// JSON to Scene, checked by the format's table. Relative paths are resolved against `folder`; see resolve_path.
Scene read_scene(const Json &json, std::string_view name, const std::filesystem::path &folder);

enum class Keys { needed, all };
/// Scene to JSON. `needed` leaves out keys at their defaults.
OrderedJson write_scene(const Scene &scene, Keys keys);

/// Absolute; a bare name that is no file in `folder` stays bare (it may be a built-in one).
std::string resolve_path(const std::string &path, const std::filesystem::path &folder);

} // namespace sandbox

#pragma once

#include "scene/assets.h"
#include "scene/scene.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// Scene files: JSON in and out. Every function throws InputError on bad input.
namespace sandbox {

/// SCENE as a command takes it: a built-in name, a .json file, a sidecar (its "scene" is read) or an .obj file
/// (shown with a default light and camera that frames it). Relative paths inside become absolute.
Scene open_scene(std::string_view name_or_path, const Assets &assets);

/// Parses scene text; `name` is used in messages, relative paths are resolved against `folder` (bare texture names
/// that are not found there are left for the built-in ones).
Scene parse_scene(std::string_view text, std::string_view name, const std::filesystem::path &folder);

/// The scene as JSON text (two-space indent); keys at their defaults are left out. Reading it back gives an equal
/// scene. For a file in `folder` (empty: for no file) paths are relative to that where they can be, see path_from().
std::string scene_text(const Scene &scene, const std::filesystem::path &folder = {});

/// Names of the built-in scenes, in the order they are taught.
std::vector<std::string> builtin_scenes(const Assets &assets);

/// The scene with its camera replaced by the named view's. Throws InputError listing the names there are.
Scene with_view(Scene scene, std::string_view view);

} // namespace sandbox

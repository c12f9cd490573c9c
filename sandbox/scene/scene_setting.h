#pragma once

#include "scene/scene.h"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

/// --set: changes of a scene as text. Throws InputError, as reading a scene file does.
namespace sandbox {

/// `lights[0].diffuse=0.5`: changes one value and checks it by the same rules. VALUE is JSON, or a bare word as a
/// string.
Scene with_setting(const Scene &scene, std::string_view path_equals_value);
/// Whether a setting's PATH is that of a file: a texture or a model.
bool names_file(std::string_view path);
/// Changes several values, then checks them together. `name` stands before the path in messages ("--set"); textures and
/// models are looked for in `folder`.
Scene with_settings(const Scene &scene, std::span<const std::string> settings, std::string_view name,
                    const std::filesystem::path &folder);

} // namespace sandbox

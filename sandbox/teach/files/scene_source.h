#pragma once

#include "scene/assets.h"
#include "scene/scene.h"
#include "teach/files/text.h"

#include <filesystem>
#include <string>

namespace sandbox {

/// The scene that a lesson or an exercise names: built in, a path beside the file (in `folder`), or written out.
/// `place` goes before what is wrong with it. Throws InputError.
Scene scene_from(const JsonText &source, const std::string &place, const std::filesystem::path &folder,
                 const Assets &assets);

} // namespace sandbox

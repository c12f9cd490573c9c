#pragma once

#include "scene/scene.h"

#include <filesystem>

namespace sandbox {

/// How wide a view is for its height, where that is not known: the window shows as much in narrower ones.
constexpr double unknown_aspect = 1.2;

/// A path that names a model (.obj, in any case), not a scene.
bool is_model(const std::filesystem::path &path);

/// The OBJ file under two lights from the viewer's side. The camera shows all of it in views of `aspect` (width by
/// height) and wider. Each material of its libraries has an object of its own. Both sides of its triangles are lit
/// where backs of them may be seen (two_sided; a note on stderr says why). Throws InputError.
Scene scene_of_model(const std::filesystem::path &path, double aspect);

} // namespace sandbox

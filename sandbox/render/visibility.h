#pragma once

#include "scene/mesh.h"
#include "scene/scene.h"

namespace sandbox {

/// Skips back faces where they cannot be seen; a mirrored object's front faces run clockwise.
void set_culling(const Camera &camera, const Object &object, const Mesh &mesh, double aspect);

} // namespace sandbox

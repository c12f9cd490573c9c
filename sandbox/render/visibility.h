#pragma once

#include "scene/mesh.h"
#include "scene/scene.h"

namespace sandbox {

/// Can no back face of this object be seen? True for a closed mesh that is neither flattened nor near enough to the eye
/// for the near plane to open it.
bool back_faces_hidden(const Camera &camera, const Object &object, const Mesh &mesh, double aspect);

/// Skips back faces where they cannot be seen; a mirrored object's front faces run clockwise.
void set_culling(const Camera &camera, const Object &object, const Mesh &mesh, double aspect);

} // namespace sandbox

#pragma once

#include "scene/mesh.h"

namespace sandbox {

/// The vertices and triangles of a built-in shape (not ObjShape), as the scene file's rules describe it: see
/// scene_format.h.
Mesh shape_mesh(const Shape &shape);

} // namespace sandbox

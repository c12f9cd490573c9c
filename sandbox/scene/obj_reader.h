#pragma once

#include "scene/mesh.h"

#include <string_view>

namespace sandbox {

/// Reads v, vt, vn, f of a Wavefront OBJ text; other keywords are ignored (mtllib with a note on stderr).
/// Polygons become fans from their first vertex; missing normals are computed (area-weighted), normals are made unit
/// (scaled first, so 1e-30 and 1e20 survive); degenerate triangles are dropped; a mesh with no triangle is refused.
/// `name` is used in messages: `bunny.obj:12: expected ...`. Throws InputError.
Mesh read_obj(std::string_view text, std::string_view name);

} // namespace sandbox

#pragma once

#include "scene/mesh.h"

#include <string>
#include <string_view>
#include <vector>

namespace sandbox {

/// Reads v, vt, vn, f, s of a Wavefront OBJ text (obj_text.h says how a text is made of lines). Indices may name what
/// comes later. How faces become a mesh: obj_mesh.h. A mesh with no triangle is refused.
/// `name` is used in messages: `bunny.obj:12: expected ...`. `notes` gets what to tell people of it: what was mended or
/// left out (lines, points, curves), one sentence each. Throws InputError.
Mesh read_obj(std::string_view text, std::string_view name, std::vector<std::string> &notes);
/// For who tells nobody.
Mesh read_obj(std::string_view text, std::string_view name);

} // namespace sandbox

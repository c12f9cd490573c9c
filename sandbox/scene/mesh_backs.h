#pragma once

#include "scene/mesh.h"

namespace sandbox {

/// Who looks at a mesh from outside and sees backs of its triangles (those that run clockwise for him), and why.
enum class BacksSeen {
    none,       ///< every connected part encloses a volume and is wound outwards
    open,       ///< some edge has a triangle on one side only, or a part encloses no volume
    inside_out, ///< a part is closed and wound inwards
};

/// By the winding alone; vertices at one position are one, whatever their normals and texture coordinates.
BacksSeen backs_seen(const Mesh &mesh);

} // namespace sandbox

#pragma once

#include "scene/mesh.h"
#include "scene/obj_faces.h"

#include <vector>

namespace sandbox {

/// The triangles of the faces: polygons split (polygon.h), triangles without area dropped, corners that agree in all
/// shared, normals made unit (scaled first, so 1e-30 and 1e20 survive), those missing or of no use computed: the sum
/// of the whole polygons' area vectors around a position, per smoothing group; unsmoothed, the polygon's own. Every
/// index must be within its list. Throws InputError (polygon.h), "line: what", without the file's name.
Mesh mesh_of_faces(const ObjFaces &faces);
/// The same, with the faces of each material apart, in the order of ObjFaces::materials; the normals computed are those
/// of the whole. A material that no triangle has gives a mesh of none.
std::vector<Mesh> meshes_of_faces(const ObjFaces &faces);

} // namespace sandbox

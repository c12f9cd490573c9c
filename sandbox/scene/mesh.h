#pragma once

#include "scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace sandbox {

/// Axis-aligned bounds in object space.
struct Bounds {
    glm::dvec3 low{0}, high{0};
};

/// An indexed triangle mesh in object space. `normals` are unit and as many as `positions`;
/// `uvs` and `colors` are as many as `positions`, or none. Counter-clockwise triangles face outward.
struct Mesh {
    std::vector<glm::dvec3> positions;
    std::vector<glm::dvec3> normals;
    std::vector<glm::dvec2> uvs;
    std::vector<glm::dvec3> colors; ///< linear RGB, which the base colour is multiplied by
    std::vector<glm::uvec3> triangles;
    /// As a reader without guards has them, where that differs: the file's own, neither unit nor mended, or sums of
    /// face normals with those of triangles without area. As many as `positions`, or none: as `normals`.
    std::vector<glm::vec3> file_normals;
    bool closed = false; ///< encloses a volume: its back faces cannot be seen from outside
    // All are set by summarise():
    Bounds bounds;
    bool opposing_normals = false;   ///< some triangle's normals may interpolate to 0
    std::size_t against_normals = 0; ///< triangles that run clockwise as seen from the side of their normals
};

/// The mesh of a built-in shape (not ObjShape), as the scene file's rules describe it. Degenerate triangles left out.
Mesh build_mesh(const Shape &shape);

/// The largest |coordinate| of any vertex: the checker's half edge R.
double half_extent(const Mesh &mesh);

Bounds bounds_of(const Mesh &mesh);

/// The face's own normal, turned to the side of its vertices' mean normal; that mean where the face has no area.
glm::dvec3 facet_normal(const Mesh &mesh, const glm::uvec3 &triangle);

/// What to tell people of meshes, so many of whose triangles have a winding that disagrees with their normals; empty:
/// none has.
std::string winding_note(std::size_t against_normals, std::size_t triangles);

/// Sets what every draw needs to know of a mesh. build_mesh() and read_obj() end with it.
void summarise(Mesh &mesh);

} // namespace sandbox

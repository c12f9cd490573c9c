#pragma once

#include "scene/mesh.h"
#include "scene/scene.h"
#include "shading/eye_space.h"
#include "shading/technique.h"

#include <vector>

/// Where normals and vertices lie that are drawn over a picture.
namespace sandbox {

/// Object space.
struct MarkedVertex {
    glm::dvec3 position, normal;
};
/// World axes and units, the eye as the origin; from == to: a dot.
struct MarkLine {
    glm::dvec3 from, to;
};

/// Shares of what the picture's height shows at the camera's target.
constexpr double normal_length = 0.06;   ///< of a normal of length 1
constexpr double normals_apart = 0.05;   ///< those that point the same way, about: dense meshes are thinned out to it
constexpr double vertices_apart = 0.012; ///< as is

/// Where a share of the picture's height at the target is a length in world units, rounded to a power of two, so that a
/// camera that comes nearer changes it seldom.
double rounded_length(const Camera &camera, double share);

/// All vertices of a mesh or, for flat shading, the middle of each triangle with the face's own normal.
std::vector<MarkedVertex> marked_vertices(const Mesh &mesh, bool flat);
/// Some of them: none is nearer than `apart` to an earlier one whose normal points the same way within 60 degrees. The
/// scale is that of the object's transform.
std::vector<MarkedVertex> thinned_out(const std::vector<MarkedVertex> &vertices, const glm::dvec3 &scale, double apart);

/// Each vertex's normal as the technique's programs transform it, not turned where a back is seen.
std::vector<MarkLine> normal_lines(const std::vector<MarkedVertex> &vertices, const Scene &scene,
                                   const Technique &technique, const Object &object, const EyeSpace &space);
std::vector<MarkLine> vertex_dots(const std::vector<MarkedVertex> &vertices, const Scene &scene, const Object &object);

/// Nearer to the eye, so that a line of so many pixels' width, in a picture of `height` pixels, lies before the surface
/// that it touches, seen at up to 75 degrees from its normal. It keeps its place in the picture.
MarkLine lifted(const MarkLine &line, const Camera &camera, double width, int height);

} // namespace sandbox

#pragma once

#include "scene/mesh.h"
#include "scene/scene.h"

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <optional>

/// Where things are: the transforms that a scene file's numbers mean, in double.
namespace sandbox {

/// Rz Ry Rx S: the linear part of an object's transform (angles in degrees about the fixed axes, x first).
glm::dmat3 linear_part(const Transform &transform);

/// Is it a rotation or a mirror image that scales all lengths alike, to double's rounding? (Then the normal matrix is
/// the matrix itself, but for a factor.)
bool scales_evenly(const glm::dmat3 &linear);

/// How far `point` (world space) is from the box around the transformed mesh that turns with it; 0 inside.
double distance_to_bounds(const Transform &transform, const Bounds &bounds, const glm::dvec3 &point);

/// Does the transform turn the mesh inside out, so that front faces run clockwise? (A determinant below 0: an odd
/// number of scales below 0, and none that is 0.)
bool is_mirrored(const Transform &transform);

/// Can no back face of the object be seen? True of a closed mesh that is neither flattened nor so near to the eye that
/// the near plane's corners (of an orthographic camera: the near plane) may reach into the box around it.
bool back_faces_hidden(const Camera &camera, double aspect, const Transform &transform, const Mesh &mesh);

/// Unit vectors of a camera in world space; `right`, `up` and `forward` are orthonormal.
struct CameraAxes {
    glm::dvec3 right, up, forward;
};
/// Whether `up` points along the view, or so nearly (to 1e-9) that rounding turns the picture: no scene file may say
/// so.
bool up_is_along_view(const Camera &camera);
/// Robust where `up` is along the view (another up is chosen).
CameraAxes camera_axes(const Camera &camera);
/// From world axes to the camera's: right, up, back.
glm::dmat3 world_to_view_axes(const Camera &camera);

/// OpenGL's clip space (z in [-w, w]) from camera-relative world space: world position minus camera.position.
glm::dmat4 view_projection(const Camera &camera, double aspect);

/// World units that the picture's height shows so far along the view; of an orthographic camera everywhere the same.
double view_height(const Camera &camera, double depth);
double height_at_target(const Camera &camera);
/// Where a point (world axes, the eye as the origin) lies in a view of `aspect` (width / height), as shares of its
/// width and height from its upper left corner, also beyond its edges; none behind the eye.
std::optional<glm::dvec2> place_in_view(const Camera &camera, double aspect, const glm::dvec3 &from_eye);

} // namespace sandbox

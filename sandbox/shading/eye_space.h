#pragma once

#include "scene/mesh.h"
#include "scene/resources.h"
#include "scene/scene.h"
#include "shading/technique.h"

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <vector>

namespace sandbox {

/// From an object's vertices to world axes with the eye as the origin. What would cost float32 its digits is taken out
/// in double: the mesh's own centre, the eye, and a unit of length.
struct EyeSpace {
    glm::dvec3 origin{0}; ///< object space: vertex buffers hold position - origin
    /// A power of two that multiplies every length a program sees, so that squares of lengths stay within float32: 1
    /// wherever they do anyhow, which is between 1e-16 and 1e16 world units from the eye.
    double scale = 1;
    /// From position - origin to (scale * (world position - eye), scale).
    glm::dmat4 model{1};
    /// For normals: sign(det A) cofactor(A) of the linear part A, scaled so that no element is larger than 1. The
    /// inverse transpose times a positive factor where A is invertible, and still a normal's matrix where A is not.
    glm::dmat3 normals{1};
    /// From position - origin to where lighting takes the surface to be: lit_scale * (world position - lit_origin), and
    /// lit_scale. The same as `model`, and lit_origin the eye, unless the object is afar (see is_afar(): its own
    /// middle) or the technique says position=absolute or is own shading (the world's origin).
    glm::dmat4 lit_model{1};
    glm::dvec3 lit_origin{0};
    double lit_scale = 1;
    bool afar = false;
    /// What a program that reads the eye is given: with position=w0 scale * (eye - the linear part of origin), which
    /// is subtracted; else the eye from lit_origin, times lit_scale.
    glm::dvec3 eye{0};
    /// Of deep scenes: window depth as the logarithm of the distance d along the view, 0 at near and 1 at far, is
    /// depth_at_1 + depth_per_octave * log2(d).
    double depth_at_1 = 0, depth_per_octave = 1;
};

/// `guarded`: false leaves out what is_afar() asks for.
EyeSpace eye_space(const Scene &scene, const Object &object, const Mesh &mesh, const Technique &technique = {},
                   bool guarded = true);

/// What programs multiply vertex normals by, and make unit unless they are unnormalized; the object's own space is 1.
glm::dmat3 normal_matrix(Normals normals, const Camera &camera, const Object &object, const EyeSpace &space);

/// The middle of a mesh that lies far from its own origin, else 0.
glm::dvec3 buffer_origin(const Mesh &mesh);

/// clip = result * (position - origin); scaled like `space`, which cancels on division by w.
glm::dmat4 model_view_projection(const Scene &scene, const EyeSpace &space, double aspect);

/// The same for programs that write the depth themselves: all of it lies at z = 0, so that near and far cut nothing.
glm::dmat4 without_depth(glm::dmat4 model_view_projection);

/// far / near from which a float32 depth buffer no longer tells surfaces apart by z / w (its step at `far` is then a
/// tenth of the distance): the logarithm of the distance is stored instead, by all objects or none. So far off a vertex
/// beyond `far` loses the same digits of z, and interpolation spreads the loss over its triangle. Never of an
/// orthographic camera, whose depth is linear.
constexpr double deep_range = 1e6;
bool is_deep(const Camera &camera);
bool is_deep(const Scene &scene, const std::vector<ObjectResources> &resources);

/// Is the object so far away for its size (32 radii) that positions from the eye lose digits that its lighting needs?
/// It is lit in positions from its own middle instead.
bool is_afar(const Scene &scene, const Object &object, const Mesh &mesh);

/// Is the object so much larger than its distance (1e4 times) that positions interpolated over it lose the digits that
/// count near the eye? They are found from the pixel and the depth instead (which a perspective camera alone has digits
/// for).
bool is_wide(const Scene &scene, const Object &object, const Mesh &mesh);

} // namespace sandbox

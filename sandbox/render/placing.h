#pragma once

#include "scene/mesh.h"
#include "scene/scene.h"

#include <glm/mat4x4.hpp>

namespace sandbox {

/// Where an object's vertices go. What would cost float32 its digits is taken out in double: the mesh's own centre, the
/// eye, and a unit of length.
struct Placing {
    glm::dvec3 origin{0}; ///< object space: vertex buffers hold position - origin
    double scale = 1;     ///< a power of two; every length that a program sees is multiplied by it
    /// From position - origin to (scale * (world position - eye), scale).
    glm::dmat4 model{1};
    glm::dvec3 eye{0}; ///< scale * (eye - the linear part of origin): what position=w0 subtracts
};

Placing place_object(const Scene &scene, const Object &object, const Mesh &mesh);

/// The middle of a mesh that lies far from its own origin, else 0.
glm::dvec3 buffer_origin(const Mesh &mesh);

/// clip = result * (position - origin); scaled like `placing`, which cancels on division by w.
glm::dmat4 model_view_projection(const Scene &scene, const Placing &placing, double aspect);

} // namespace sandbox

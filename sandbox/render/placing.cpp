#include "render/placing.h"

#include "scene/space.h"
#include "shading/length_scale.h"

#include <glm/geometric.hpp>

namespace sandbox {

glm::dvec3 buffer_origin(const Mesh &mesh) {
    const Bounds &bounds = mesh.bounds;
    const glm::dvec3 middle = 0.5 * (bounds.low + bounds.high);
    const double extent = glm::length(bounds.high - bounds.low);
    // Nearer than that, at most four of float32's bits are lost.
    const bool far = glm::length(middle) > 8 * extent;
    return far ? middle : glm::dvec3(0);
}

Placing place_object(const Scene &scene, const Object &object, const Mesh &mesh) {
    Placing placing;
    const glm::dmat3 linear = linear_part(object.transform);
    placing.origin = buffer_origin(mesh);
    placing.scale = length_scale(scene, object, mesh);
    const glm::dvec3 moved = linear * placing.origin;
    placing.model = glm::dmat4(linear * placing.scale);
    placing.model[3] =
        glm::dvec4((moved + (object.transform.translate - scene.camera.position)) * placing.scale, placing.scale);
    placing.eye = (scene.camera.position - moved) * placing.scale;
    return placing;
}

glm::dmat4 model_view_projection(const Scene &scene, const Placing &placing, double aspect) {
    return view_projection(scene.camera, aspect) * placing.model;
}

} // namespace sandbox

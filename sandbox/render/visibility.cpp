#include "render/visibility.h"

#include "scene/space.h"

#include <glad/gl.h>

namespace sandbox {

void set_culling(const Camera &camera, const Object &object, const Mesh &mesh, double aspect) {
    glFrontFace(is_mirrored(object.transform) ? GL_CW : GL_CCW);
    (back_faces_hidden(camera, aspect, object.transform, mesh) ? glEnable : glDisable)(GL_CULL_FACE);
}

} // namespace sandbox

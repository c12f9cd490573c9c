#pragma once

#include "image/image.h"
#include "render/gl_program.h"
#include "scene/mesh.h"
#include "scene/scene.h"
#include "shading/features.h"

namespace sandbox {

/// What one draw of one object uploads. Positions are relative to the eye, computed in double.
struct DrawInput {
    const Scene &scene;
    const Technique &technique;
    const Object &object;
    const Mesh &mesh;
    Size size;          ///< of the picture
    unsigned object_id; ///< index + 1

    [[nodiscard]] double aspect() const { return static_cast<double>(size.width) / static_cast<double>(size.height); }
};

/// Sets every active uniform of `program`, which is in use. Throws std::logic_error if one stays unset.
void upload_uniforms(const GlProgram &program, const DrawInput &input);

} // namespace sandbox

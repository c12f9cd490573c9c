#pragma once

#include "image/image.h"
#include "render/uploader.h"
#include "shading/prepared_object.h"

namespace sandbox {

/// One draw of one object.
struct ObjectDraw {
    const Scene &scene;
    const Object &object;
    const Mesh &mesh;
    const PreparedObject &prepared;
    Size size;          ///< of the picture
    unsigned object_id; ///< index + 1
    double exposure;    ///< of what is drawn as a screen shows it

    [[nodiscard]] double aspect() const { return aspect_of(size); }
};

/// What a full program branches on.
void put_choices(UniformSink &sink, const Features &object);

/// Sets every active uniform of `program`, which is in use. Throws std::logic_error if one stays unset.
void upload_uniforms(const GlProgram &program, const ObjectDraw &draw);

/// The values of all that a baked program of this draw can write in. Needs no OpenGL.
UniformValues uniform_values(const ObjectDraw &draw);

} // namespace sandbox

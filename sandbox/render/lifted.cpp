#include "render/lifted.h"

#include <cmath>

namespace sandbox {

void put_lifted(const GlProgram &program, const Scene &scene, const EyeSpace &space, Size size, bool deep,
                double pixels) {
    const Camera &camera = scene.camera;
    const double lift = pixels * view_height(camera, 1) / size.height; // perspective: a share of the distance
    glm::dmat4 to_clip = model_view_projection(scene, space, aspect_of(size));
    if (deep) {
        to_clip = without_depth(to_clip);
        program.set("depth_per_octave", static_cast<float>(space.depth_per_octave));
        program.set("depth_at_1", static_cast<float>(space.depth_at_1 - space.depth_per_octave * std::log2(1 + lift)));
    } else if (is_perspective(camera)) { // the eye's own column is what does not shrink with the distance
        to_clip[3].z += lift * view_projection(camera, aspect_of(size))[3].z * space.scale;
    } else {
        to_clip[3].z -= lift * 2 / (camera.far_plane - camera.near_plane) * space.scale;
    }
    program.set("model_view_projection", glm::mat4(to_clip));
}

} // namespace sandbox

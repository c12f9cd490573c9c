#include "render/log_depth.h"

#include <cmath>
#include <glm/trigonometric.hpp>

namespace sandbox {

LogDepth log_depth(const Camera &camera, double scale) {
    const double per_octave = 1 / std::log2(camera.far_plane / camera.near_plane);
    return {per_octave, -std::log2(camera.near_plane * scale) * per_octave};
}

double line_lift(const Camera &camera, int picture_height) {
    const double half_pixel = std::tan(glm::radians(camera.fov_y_degrees) / 2) / picture_height; // at a distance of 1
    return 14 * half_pixel;
}

} // namespace sandbox

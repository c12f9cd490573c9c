#include "measure/diagnosis/point_samples.h"

#include <cmath>
#include <glm/trigonometric.hpp>

namespace sandbox {
namespace {

/// Pixels cut off before the first sample's own `step` pixels.
int margin(int full, int samples, int step) { return (full - samples * step) / 2; }

/// How many samples fit such that both borders lose the same: the middle of the picture stays its middle.
int fitting(int full, int step) {
    const int most = full / step;
    return (full - most * step) % 2 == 0 ? most : most - 1;
}

} // namespace

std::size_t PointSamples::pixel(int x, int y) const {
    const int column = margin(full.width, size.width, step) + step * x + step / 2;
    const int row = margin(full.height, size.height, step) + step * y + step / 2;
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(full.width) + static_cast<std::size_t>(column);
}

PointSamples point_samples(Size full, int most) {
    PointSamples samples{full, full, 1};
    for (int step = 3; static_cast<long>(samples.size.width) * samples.size.height > most; step += 2) {
        const Size size{fitting(full.width, step), fitting(full.height, step)};
        if (size.width < 1 || size.height < 1) {
            break;
        }
        samples = {full, size, step};
    }
    return samples;
}

Camera sampled_camera(Camera camera, const PointSamples &samples) {
    const double share = static_cast<double>(samples.step * samples.size.height) / samples.full.height;
    if (is_orthographic(camera)) {
        camera.height *= share;
    } else if (samples.step > 1) {
        const double half = glm::radians(camera.fov_y_degrees) / 2;
        camera.fov_y_degrees = glm::degrees(2 * std::atan(share * std::tan(half)));
    }
    return camera;
}

} // namespace sandbox

#include "capture/samples.h"

#include "image/error.h"
#include "image/thread.h"

#include <cmath>
#include <vector>

namespace sandbox {
namespace {

/// Van der Corput's sequence: the binary digits of `index` behind the point, in turned order.
double radical_inverse(int index) {
    double sum = 0;
    for (double digit = 0.5; index > 0; index /= 2, digit /= 2) {
        sum += digit * (index % 2);
    }
    return sum;
}

} // namespace

glm::dvec2 sample_offset(int index, int count) {
    // Half a step further in both directions, so that the points' mean is the centre.
    return {(index + 0.5) / count - 0.5, radical_inverse(index) + 0.5 / count - 0.5};
}

int checked_samples(double count) {
    if (!(count >= 1 && count <= most_samples && count == std::floor(count))) {
        throw InputError("expected a whole number from 1 to {}, got {:g}", most_samples, count);
    }
    return static_cast<int>(count);
}

Image draw_samples(const Scene &scene, Size size, int count, const std::function<Image(const Scene &)> &draw) {
    if (count == 1) {
        return draw(scene);
    }
    std::vector<glm::dvec4> sums(Image(size).pixels.size());
    Scene shifted = scene;
    for (int i = 0; i < count; ++i) {
        const glm::dvec2 offset = sample_offset(i, count);
        shifted.camera.picture_shift = {-2 * offset.x / size.width, 2 * offset.y / size.height};
        const Image sample = draw(shifted);
        let_others_run();
        for (std::size_t k = 0; k < sums.size(); ++k) {
            sums[k] += glm::dvec4(sample.pixels[k]);
        }
    }
    Image mean(size);
    for (std::size_t k = 0; k < sums.size(); ++k) {
        mean.pixels[k] = glm::vec4(sums[k] / static_cast<double>(count));
    }
    return mean;
}

} // namespace sandbox

#include "measure/metrics/profile.h"

namespace sandbox {

Curve luminance_row(const Image &image, int row) {
    Curve curve;
    for (int x = 0; row < image.size.height && x < image.size.width; ++x) {
        curve.push_back(luminance(image.at(x, row)));
    }
    return curve;
}

} // namespace sandbox

#include "measure/work_precision/precision.h"

#include "reference/reference.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sandbox {

double levels_between(const Image &a, const Image &b) {
    double most = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        for (int channel = 0; channel < 3; ++channel) {
            const auto shown = [&](const Image &image) {
                const auto value = static_cast<double>(image.pixels[i][channel]);
                return std::isfinite(value) ? std::clamp(value, 0.0, 1.0) : std::numeric_limits<double>::quiet_NaN();
            };
            const double by = std::abs(shown(a) - shown(b));
            most = std::isnan(by) ? std::numeric_limits<double>::infinity() : std::max(most, 255 * by);
        }
    }
    return most;
}

PrecisionFinding find_precision(const Scene &scene, const std::vector<ObjectResources> &resources,
                                const Technique &technique, Size size) {
    Technique medium = technique;
    medium.precision = Precision::medium;
    const Image truth = reference_colors(scene, resources, technique, size);
    const auto levels = [&](const reference::HighValues &high) {
        return levels_between(reference_colors(scene, resources, medium, size, high), truth);
    };
    PrecisionFinding finding{.technique = technique, .rounded = levels({}), .device = {}, .high = {}, .left = 0};
    reference::HighValues high = reference::HighValues().set();
    for (std::size_t before = 0; before != high.count();) { // what the later ones leave may do without an earlier one
        before = high.count();
        for (std::size_t i = reference::kept_count; i-- > 0;) {
            if (!high.test(i)) {
                continue;
            }
            high.reset(i);
            if (const double left = levels(high); left > 1) {
                high.set(i);
            } else {
                finding.left = left;
            }
        }
    }
    for (std::size_t i = 0; i < reference::kept_count; ++i) {
        if (high.test(i)) {
            finding.high.emplace_back(reference::kept_names.at(i));
        }
    }
    return finding;
}

} // namespace sandbox

#pragma once

#include "image/image.h"
#include "scene/scene.h"

#include <vector>

namespace sandbox {

/// Some of a picture's pixels, evenly apart: a small picture whose pixels have the same centres, so that thin features
/// stay as sharp as they are. What lies at the borders is cut off.
struct PointSamples {
    Size full, size; ///< of the whole picture, of the small one
    int step = 1;    ///< pixels of the whole picture from one sample to the next; odd, as their centres must meet
    [[nodiscard]] std::size_t pixel(int x, int y) const; ///< of the whole picture, under (x, y) of the small one
};

/// At most about `most` samples; at least one.
PointSamples point_samples(Size full, int most);
/// Draws the small picture.
Camera sampled_camera(Camera camera, const PointSamples &samples);

/// The samples of what has `channels` values a pixel.
template <class Value>
std::vector<Value> sampled(const std::vector<Value> &values, const PointSamples &samples, std::size_t channels = 1) {
    std::vector<Value> some;
    for (int y = 0; y < samples.size.height; ++y) {
        for (int x = 0; x < samples.size.width; ++x) {
            for (std::size_t c = 0; c < channels; ++c) {
                some.push_back(values[channels * samples.pixel(x, y) + c]);
            }
        }
    }
    return some;
}

} // namespace sandbox

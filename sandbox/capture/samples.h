#pragma once

#include "image/image.h"
#include "scene/scene.h"

#include <functional>
#include <glm/vec2.hpp>

/// Sub-pixel samples: smooth edges for pictures to show. Whatever is measured has one sample, at the pixel's centre.
namespace sandbox {

constexpr int most_samples = 256;
constexpr int samples_at_rest = 16; ///< of the window's pictures, once nothing moves

/// Sample `index` of `count`, from the pixel's centre, in pixels (x to the right, y down), each within half a pixel:
/// the points of Hammersley's set, one in each of `count` equal columns and, for powers of two, rows. Of one sample, 0.
glm::dvec2 sample_offset(int index, int count);

/// Throws InputError unless it is a whole number from 1 to most_samples.
int checked_samples(double count);

/// The mean of the linear colours that `draw` gives the pixels' samples; of one sample, its picture unchanged.
Image draw_samples(const Scene &scene, Size size, int count, const std::function<Image(const Scene &)> &draw);

} // namespace sandbox

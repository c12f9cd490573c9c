#pragma once

#include "image/image.h"

#include <glm/vec3.hpp>

/// How two pictures differ, for eyes. The twin of difference_fragment.glsl.
namespace sandbox {

/// `value` is gain * (first - second), from -1 (second brighter: blue) over 0 (equal: white) to +1 (first brighter:
/// orange). The palette is safe for colour-blind eyes.
glm::vec3 difference_color(float value);

/// The signed difference of each pixel's channel that differs most, over a faint outline of the first picture; magenta
/// where either is not finite. The pictures have one size.
ByteImage difference_picture(const Image &first, const Image &second, double gain);

/// Of any channel of any pixel; infinite if a pixel of either is not finite.
double largest_difference(const Image &first, const Image &second);

} // namespace sandbox

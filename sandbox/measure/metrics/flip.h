#pragma once

#include "image/image.h"

#include <vector>

namespace sandbox {

/// The viewing distance that FLIP assumes: 0.7 m from a 0.7 m wide display of 3840 pixels.
constexpr double flip_pixels_per_degree = 67.02064327658225;

/// LDR FLIP per pixel, in [0, 1]: what an observer notices when flipping between two pictures. Bytes are read as sRGB.
/// P. Andersson, J. Nilsson, T. Akenine-Moller, M. Oskarsson, K. Astrom, M. D. Fairchild: FLIP: A Difference Evaluator
/// for Alternating Images, Proc. ACM CGIT 3(2), 2020. Symmetric. Throws std::invalid_argument if the sizes differ.
std::vector<float> flip_map(const ByteImage &reference, const ByteImage &test,
                            double pixels_per_degree = flip_pixels_per_degree);

/// The mean of flip_map; 0 for empty pictures.
double mean_flip(const ByteImage &reference, const ByteImage &test, double pixels_per_degree = flip_pixels_per_degree);

} // namespace sandbox

#pragma once

#include <vector>

/// The one-dimensional kernels that FLIP's filters are made of. Every filter is separable, or a sum of two that are.
namespace sandbox::flip {

/// Odd length, centred.
using Kernel = std::vector<float>;

/// A Gaussian pair over rows and columns: sum over `parts` of rows (x) rows; the whole 2D filter sums to 1.
struct ContrastFilter {
    std::vector<Kernel> parts; ///< used both along rows and along columns
};

/// The contrast sensitivity of the eye to one opponent channel, as a spatial filter: sum of
/// a sqrt(pi / b) exp(-pi^2 x^2 / b), x in degrees (section 4.1.1).
struct ContrastFilters {
    ContrastFilter achromatic, red_green, blue_yellow;
};
ContrastFilters contrast_filters(double pixels_per_degree);

/// Edges and points in luminance: first and second derivative of a Gaussian whose width is that of the eye's edge
/// detector, positive weights scaled to sum to 1, negative to -1 (section 4.2). Along one axis the derivative, along
/// the other the smoothing.
struct FeatureFilters {
    Kernel smoothing, edge, point;
};
FeatureFilters feature_filters(double pixels_per_degree);

} // namespace sandbox::flip

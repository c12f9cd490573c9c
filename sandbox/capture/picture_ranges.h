#pragma once

#include "scene/scene_format.h"

/// What the numbers of a picture may be: on the command line, in a sidecar and in the window.
namespace sandbox {

constexpr Range exposure_range{.low = 0, .high = 1e6, .slider = {0.05, 20, "%.3g", true}};
constexpr Range gain_range{.low = 1e-6, .high = 1e9, .slider = {1, 1000, "%.4g", true}};

/// The number. Throws InputError: "expected a number >= 0, got -1".
double checked_number(double value, const Range &range);

} // namespace sandbox

#pragma once

#include "certificate/jet.h"
#include "scene/scene.h"

#include <optional>

/// The functions of one number that the shading equations are made of, as curves over an interval.
/// Where a function has no second derivative that is bounded on it, the result is none.
namespace sandbox::certificate {

/// 1 / sqrt(x); x > 0.
std::optional<Curve> inverse_root(const Interval &x);

/// Attenuation as a function of d^2 (not d, so that it is smooth in the point). None where its floor may count, or d
/// may be 0 while d itself counts.
std::optional<Curve> attenuation(const Attenuation &k, const Interval &square_distance);
/// The same times 1 / d.
std::optional<Curve> attenuation_over_distance(const Attenuation &k, const Interval &square_distance);

/// max(x, 0)^n with x^0 = 1; n >= 0. Second derivatives may jump (n = 2 at 0) but stay bounded.
std::optional<Curve> power(const Interval &x, double n);

/// smoothstep(from, to, x), from < to. Its second derivative jumps at both ends.
Curve smooth_step(double from, double to, const Interval &x);

} // namespace sandbox::certificate

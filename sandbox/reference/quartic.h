#pragma once

#include <array>

namespace sandbox::reference {

/// Real roots in ascending order; a double root counts once or twice.
struct Roots {
    std::array<double, 4> values{};
    int count = 0;
};

/// The roots of x^4 + p x^2 + q x + r in [-bound, bound]. Found between the turning points by bisection and Newton
/// steps: no cancelling closed form, every root to the last few bits of what the coefficients say.
Roots depressed_quartic_roots(double p, double q, double r, double bound);

} // namespace sandbox::reference

#include "certificate/interpolation_bound.h"

#include <algorithm>

namespace sandbox::certificate {

double largest_sum(double a, double b, double c) {
    const double longest = std::max({a, b, c});
    const double sum = a + b + c;
    if (2 * longest >= sum * (1 - 1e-9)) { // no acute triangle: the longest edge is the circle's diameter
        return up(longest / 4, 1 << 24);   // what the branch taken a little early leaves out is below 1e-9 of it
    }
    // Scaled, so that no product vanishes. 16 area^2 = (sum)^2 - 2 (a^2 + b^2 + c^2).
    a /= longest;
    b /= longest;
    c /= longest;
    const double area = 2 * (a * b + b * c + c * a) - (a * a + b * b + c * c);
    return longest * (a * b * c / area) * (1 + 1e-6);
}

double interpolation_bound(const Hessian &hessian) {
    const Interval along[3] = {hessian.vv - 2.0 * hessian.uv + hessian.uu, hessian.vv, hessian.uu};
    double above[3], below[3], varies = 0;
    for (int i = 0; i < 3; ++i) {
        above[i] = std::max(along[i].hi, 0.0);
        below[i] = std::max(-along[i].lo, 0.0);
        varies += along[i].radius();
    }
    if (!(varies < std::numeric_limits<double>::max())) { // some entry is unbounded, or no number
        return std::numeric_limits<double>::infinity();
    }
    // li lj (1 + 2 lk) p = li lj p + 2 l0 l1 l2 p, and l0 l1 l2 <= 1/27.
    const double sum = std::max(largest_sum(above[0], above[1], above[2]), largest_sum(below[0], below[1], below[2]));
    return up(0.5 * (sum + (2.0 / 27) * varies), 16);
}

double kinked_bound(const Hessian &hessian, const Interval &value) {
    if (value.lo >= 0) {
        return interpolation_bound(hessian);
    }
    if (value.hi <= 0) {
        return 0;
    }
    // Of a linear f with corners in [lo, hi] the interpolant of max(f, 0) strays by hi |lo| / (hi - lo) at most: at
    // weights whose part on corners above 0 is w, it is min(w hi, (1 - w) |lo|) or less.
    const double kink = value.hi * (-value.lo / (value.hi - value.lo));
    return std::min(up(kink + interpolation_bound(hessian), 16), value.hi);
}

} // namespace sandbox::certificate

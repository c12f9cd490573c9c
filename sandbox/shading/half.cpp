#include "shading/half.h"

#include <cmath>
#include <limits>

namespace sandbox {

double to_half(double x) {
    constexpr double smallest = 0x1p-14;
    const double size = std::abs(x);
    if (!std::isfinite(x) || size >= 65520) {
        return std::isnan(x) ? x : std::copysign(std::numeric_limits<double>::infinity(), x);
    }
    if (size < smallest - 0x1p-25) { // nearer to a subnormal
        return std::copysign(0.0, x);
    }
    const double step = size < smallest ? 0x1p-24 : std::ldexp(1.0, std::ilogb(size) - 10);
    return std::nearbyint(x / step) * step;
}

} // namespace sandbox

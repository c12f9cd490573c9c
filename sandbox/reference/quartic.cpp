#include "reference/quartic.h"

#include <cmath>

namespace sandbox::reference {

namespace {

/// A root of f between low and high, where f has opposite signs and no turning point. Newton, kept inside by bisection.
template <class F, class Slope> double bracketed_root(const F &f, const Slope &slope, double low, double high) {
    const bool rising = f(low) < 0;
    double x = 0.5 * (low + high);
    for (int step = 0; step < 200; ++step) {
        const double value = f(x);
        if (value == 0) {
            return x;
        }
        ((value < 0) == rising ? low : high) = x;
        const double newton = x - value / slope(x);
        const double next = newton > low && newton < high ? newton : 0.5 * (low + high);
        if (next == x || !(low < high)) {
            return x;
        }
        x = next;
    }
    return x;
}

/// The roots of f on [stops[0], stops[count - 1]]; the stops between are all its turning points there.
template <class F, class Slope>
Roots roots_between(const F &f, const Slope &slope, const std::array<double, 5> &stops, int count) {
    Roots roots;
    for (int i = 0; i + 1 < count; ++i) {
        const double low = stops[static_cast<std::size_t>(i)];
        const double high = stops[static_cast<std::size_t>(i) + 1];
        const double at_low = f(low);
        const double at_high = f(high);
        if (at_low == 0) {
            roots.values[static_cast<std::size_t>(roots.count++)] = low;
        } else if (at_high != 0 && (at_low < 0) != (at_high < 0) && roots.count < 4) {
            roots.values[static_cast<std::size_t>(roots.count++)] = bracketed_root(f, slope, low, high);
        }
        if (roots.count == 4) {
            break;
        }
    }
    return roots;
}

/// -bound, the turning points inside the interval, bound.
int stops_of(double bound, const Roots &turning, std::array<double, 5> &stops) {
    int count = 0;
    stops[static_cast<std::size_t>(count++)] = -bound;
    for (int i = 0; i < turning.count; ++i) {
        const double x = turning.values[static_cast<std::size_t>(i)];
        if (x > -bound && x < bound && count < 4) {
            stops[static_cast<std::size_t>(count++)] = x;
        }
    }
    stops[static_cast<std::size_t>(count++)] = bound;
    return count;
}

} // namespace

Roots depressed_quartic_roots(double p, double q, double r, double bound) {
    const auto quartic = [=](double x) { return ((x * x + p) * x + q) * x + r; };
    const auto cubic = [=](double x) { return (4 * x * x + 2 * p) * x + q; };
    const auto square = [=](double x) { return 12 * x * x + 2 * p; };
    std::array<double, 5> stops{};

    Roots bends;
    if (p < 0) {
        const double bend = std::sqrt(-p / 6);
        bends = {{-bend, bend}, 2};
    }
    int count = stops_of(bound, bends, stops);
    const Roots turning = roots_between(cubic, square, stops, count);
    count = stops_of(bound, turning, stops);
    return roots_between(quartic, cubic, stops, count);
}

} // namespace sandbox::reference

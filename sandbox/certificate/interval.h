#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

/// Interval arithmetic in double: the result of an operation holds every result that its arguments' members can have.
namespace sandbox::certificate {

struct Interval {
    double lo = 0, hi = 0;

    constexpr Interval() = default;
    constexpr Interval(double value) : lo(value), hi(value) {} // NOLINT(google-explicit-constructor): a number is one
    constexpr Interval(double low, double high) : lo(low), hi(high) {}

    [[nodiscard]] constexpr double middle() const { return 0.5 * (lo + hi); }
    /// At least half the width, also where middle() was rounded.
    [[nodiscard]] constexpr double radius() const { return (0.5 + 0x1p-50) * (hi - lo) + 0x1p-52 * magnitude(); }
    [[nodiscard]] constexpr double magnitude() const { return std::max(-lo, hi); }
    [[nodiscard]] constexpr bool holds(double value) const { return lo <= value && value <= hi; }
};

/// Round-to-nearest errs by half a unit in the last place; this steps outward by one.
constexpr double one_step = std::numeric_limits<double>::epsilon();
constexpr double down(double x, double steps = 1) { return x - steps * one_step * (x < 0 ? -x : x); }
constexpr double up(double x, double steps = 1) { return x + steps * one_step * (x < 0 ? -x : x); }
constexpr Interval outward(double lo, double hi, double steps = 1) { return {down(lo, steps), up(hi, steps)}; }

inline Interval operator-(const Interval &a) { return {-a.hi, -a.lo}; }
inline Interval operator+(const Interval &a, const Interval &b) { return outward(a.lo + b.lo, a.hi + b.hi); }
inline Interval operator-(const Interval &a, const Interval &b) { return outward(a.lo - b.hi, a.hi - b.lo); }
inline Interval operator*(const Interval &a, const Interval &b) {
    const double p = a.lo * b.lo, q = a.lo * b.hi, r = a.hi * b.lo, s = a.hi * b.hi;
    return outward(std::min(std::min(p, q), std::min(r, s)), std::max(std::max(p, q), std::max(r, s)));
}
inline Interval operator*(double a, const Interval &b) {
    return a < 0 ? outward(a * b.hi, a * b.lo) : outward(a * b.lo, a * b.hi);
}
inline Interval square(const Interval &a) {
    const double p = a.lo * a.lo, q = a.hi * a.hi;
    return a.lo < 0 && a.hi > 0 ? Interval{0, up(std::max(p, q))} : outward(std::min(p, q), std::max(p, q));
}
/// The quotient of numbers above 0: b.lo > 0.
inline Interval over_positive(const Interval &a, const Interval &b) {
    return outward(a.lo / (a.lo < 0 ? b.lo : b.hi), a.hi / (a.hi < 0 ? b.hi : b.lo));
}

inline Interval hull(const Interval &a, const Interval &b) { return {std::min(a.lo, b.lo), std::max(a.hi, b.hi)}; }
/// Both hold the same number: so does what they share.
inline Interval shared(const Interval &a, const Interval &b) { return {std::max(a.lo, b.lo), std::min(a.hi, b.hi)}; }

// The same words for plain numbers, so that what is written for intervals also runs at one point.
inline double square(double a) { return a * a; }
inline double over_positive(double a, double b) { return a / b; }
inline double lowest(double a) { return a; }
inline double highest(double a) { return a; }
inline double lowest(const Interval &a) { return a.lo; }
inline double highest(const Interval &a) { return a.hi; }

} // namespace sandbox::certificate

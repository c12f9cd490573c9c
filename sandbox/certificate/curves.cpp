#include "certificate/curves.h"

#include <algorithm>

namespace sandbox::certificate {
namespace {

struct CurvePoint {
    double value, first, second;
};

/// More than the roundings of any of the formulas here, none of which cancels.
constexpr double steps = 32;
constexpr double attenuation_floor = 1e-6;

/// Of a function whose value falls, whose first derivative rises and whose second falls (a completely monotone one):
/// 1 / sqrt(x) is, and so is 1 / (kc + kl sqrt(x) + kq x), and so are products of such.
template <class F> Curve between_ends(const Interval &x, const F &f) {
    const CurvePoint first = f(x.lo);
    const CurvePoint last = f(x.hi);
    return {outward(last.value, first.value, steps), outward(first.first, last.first, steps),
            outward(last.second, first.second, steps)};
}

double denominator(const Attenuation &k, double square_distance) {
    return k.constant + k.linear * std::sqrt(square_distance) + k.quadratic * square_distance;
}

CurvePoint inverse_root_at(double x) {
    const double root = 1 / std::sqrt(x);
    return {root, -0.5 * root / x, 0.75 * root / (x * x)};
}

CurvePoint attenuation_at(const Attenuation &k, double square_distance) {
    const double q = square_distance;
    const double value = 1 / denominator(k, q);
    const double slope = (k.linear != 0 ? 0.5 * k.linear / std::sqrt(q) : 0) + k.quadratic;
    const double bend = k.linear != 0 ? 0.25 * k.linear / (q * std::sqrt(q)) : 0; // -second derivative
    return {value, -slope * value * value, (2 * slope * slope * value + bend) * value * value};
}

CurvePoint product(const CurvePoint &a, const CurvePoint &b) {
    return {a.value * b.value, a.first * b.value + a.value * b.first,
            a.second * b.value + 2 * a.first * b.first + a.value * b.second};
}

} // namespace

std::optional<Curve> inverse_root(const Interval &x) {
    if (!(x.lo > 0)) {
        return {};
    }
    return between_ends(x, [](double at) { return inverse_root_at(at); });
}

std::optional<Curve> attenuation(const Attenuation &k, const Interval &square_distance) {
    const Interval q{std::max(square_distance.lo, 0.0), square_distance.hi};
    if (!(down(denominator(k, q.lo), steps) > attenuation_floor) || (k.linear != 0 && !(q.lo > 0))) {
        return {};
    }
    return between_ends(q, [&](double at) { return attenuation_at(k, at); });
}

std::optional<Curve> attenuation_over_distance(const Attenuation &k, const Interval &square_distance) {
    if (!(square_distance.lo > 0) || !(down(denominator(k, square_distance.lo), steps) > attenuation_floor)) {
        return {};
    }
    return between_ends(square_distance,
                        [&](double at) { return product(attenuation_at(k, at), inverse_root_at(at)); });
}

std::optional<Curve> power(const Interval &x, double n) {
    if (n == 0) {
        return Curve{1.0, 0.0, 0.0};
    }
    if (x.hi <= 0) {
        return Curve{};
    }
    if (x.lo <= 0 && n < 2) {
        return {};
    }
    const double lo = std::max(x.lo, 0.0);
    const double p = std::pow(lo, n), q = std::pow(x.hi, n);
    const auto slope = [&](double at, double raised) { return at > 0 ? n * raised / at : 0; };
    const auto bend = [&](double at, double raised) { return at > 0 ? n * (n - 1) * (raised / at) / at : 0; };
    Curve curve{outward(p, q, steps), {}, {}};
    const double a = slope(lo, p), b = slope(x.hi, q), c = bend(lo, p), d = bend(x.hi, q);
    curve.first = outward(std::min(a, b), std::max(a, b), steps);
    curve.second = outward(std::min(c, d), std::max(c, d), steps);
    if (x.lo <= 0) {
        curve.first.lo = std::min(curve.first.lo, 0.0);
        curve.second.lo = std::min(curve.second.lo, 0.0);
    }
    return curve;
}

Curve smooth_step(double from, double to, const Interval &x) {
    const Interval width = Interval{to} - Interval{from};
    const Interval steepness = over_positive(1.0, width);
    const auto place = [&](double at) { return shared((Interval{at} - Interval{from}) * steepness, {-1, 2}); };
    const auto clamped = [](double t) { return std::clamp(t, 0.0, 1.0); };
    const auto risen = [](double t) { return t * t * (3 - 2 * t); };
    const double raw_lo = place(std::clamp(x.lo, from - (to - from), to + (to - from))).lo;
    const double raw_hi = place(std::clamp(x.hi, from - (to - from), to + (to - from))).hi;
    const double lo = clamped(raw_lo), hi = clamped(raw_hi);
    const auto slope = [](double t) { return 6 * t * (1 - t); };
    const double ends[2] = {slope(lo), slope(hi)};
    Interval first = outward(std::min(ends[0], ends[1]), lo <= 0.5 && hi >= 0.5 ? 1.5 : std::max(ends[0], ends[1]), 8);
    Interval second = outward(6 - 12 * hi, 6 - 12 * lo, 8);
    second.lo -= 8 * one_step * 12;
    second.hi += 8 * one_step * 12;
    if (raw_lo <= 0 || raw_hi >= 1) { // beyond an end it is constant
        first = hull(first, 0.0);
        second = hull(second, 0.0);
    }
    if (raw_hi <= 0 || raw_lo >= 1) {
        first = second = 0.0;
    }
    return {outward(risen(lo), risen(hi), 16), first * steepness, second * (steepness * steepness)};
}

} // namespace sandbox::certificate

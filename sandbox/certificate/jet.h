#pragma once

#include "certificate/interval.h"

#include <array>
#include <glm/vec3.hpp>

/// A function of a triangle's two weights (u, v) with its first and second derivatives: every member holds all values
/// that it takes over the triangle, or at one point of it.
namespace sandbox::certificate {

struct Jet {
    Interval value{0};
    Interval u{0}, v{0};
    Interval uu{0}, uv{0}, vv{0};
};

inline Jet operator+(const Jet &a, const Jet &b) {
    return {a.value + b.value, a.u + b.u, a.v + b.v, a.uu + b.uu, a.uv + b.uv, a.vv + b.vv};
}
inline Jet operator-(const Jet &a, const Jet &b) {
    return {a.value - b.value, a.u - b.u, a.v - b.v, a.uu - b.uu, a.uv - b.uv, a.vv - b.vv};
}
inline Jet operator*(double k, const Jet &a) { return {k * a.value, k * a.u, k * a.v, k * a.uu, k * a.uv, k * a.vv}; }
inline Jet operator*(const Jet &a, const Jet &b) {
    return {a.value * b.value,
            a.u * b.value + a.value * b.u,
            a.v * b.value + a.value * b.v,
            a.uu * b.value + 2.0 * (a.u * b.u) + a.value * b.uu,
            a.uv * b.value + a.u * b.v + a.v * b.u + a.value * b.uv,
            a.vv * b.value + 2.0 * (a.v * b.v) + a.value * b.vv};
}

/// A function of one number with its first and second derivatives, for all numbers that it is applied to.
struct Curve {
    Interval value{0}, first{0}, second{0};
};
inline Curve operator*(const Curve &a, const Curve &b) {
    return {a.value * b.value, a.first * b.value + a.value * b.first,
            a.second * b.value + 2.0 * (a.first * b.first) + a.value * b.second};
}
inline Jet compose(const Curve &f, const Jet &a) {
    return {f.value,
            f.first * a.u,
            f.first * a.v,
            f.second * square(a.u) + f.first * a.uu,
            f.second * (a.u * a.v) + f.first * a.uv,
            f.second * square(a.v) + f.first * a.vv};
}
inline Interval compose(const Curve &f, const Interval &) { return f.value; }

inline Interval &value_of(Interval &number) { return number; }
inline Interval &value_of(Jet &number) { return number.value; }
inline const Interval &value_of(const Interval &number) { return number; }
inline const Interval &value_of(const Jet &number) { return number.value; }

/// A vector that is linear over a triangle, by its values at the corners (u, v) = (0, 0), (1, 0) and (0, 1).
using Linear = std::array<glm::dvec3, 3>;

/// The dot product of two of them ...
/// over the triangle, or with `at_centroid` there alone: a polynomial of degree 2, which lies between the smallest and
/// the largest of its Bernstein coefficients; its first derivatives are linear, between their values at the corners;
struct OverTriangle {
    using Number = Jet;
    bool at_centroid = false;
    Jet operator()(const Linear &a, const Linear &b) const;
};
/// at the point with these weights of the corners, without derivatives.
struct AtPoint {
    using Number = Interval;
    glm::dvec3 weights;
    Interval operator()(const Linear &a, const Linear &b) const;
};

/// What is known of `over` a triangle, narrowed by what the same function is `at` the centroid: the value by the mean
/// value theorem, the first derivatives likewise.
Jet narrowed(const Jet &over, const Jet &at);

} // namespace sandbox::certificate

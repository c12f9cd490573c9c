#pragma once

#include "shading/half.h"

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>

/// Arithmetic as the fragment stage of a half-float device does it, but for what is declared highp: an operation is as
/// precise as its most precise operand (GLSL ES 3.00, 4.5.2), and a medium one is rounded to half. Functions are their
/// operations by component, in written order.
namespace sandbox::reference {

struct Number {
    double value = 0; ///< a medium one is a half
    bool high = false;
};
struct Triple {
    Number x, y, z;
};

/// The result of one operation.
inline Number rounded(double value, bool high) { return {high ? value : to_half(value), high}; }
inline Triple rounded(const glm::dvec3 &v, bool high) {
    return {rounded(v.x, high), rounded(v.y, high), rounded(v.z, high)};
}
/// A number of the text, as precise as what it meets.
inline Number beside(const Number &other, double literal) { return rounded(literal, other.high); }

inline Number operator-(const Number &a) { return {-a.value, a.high}; }
inline Number operator+(const Number &a, const Number &b) { return rounded(a.value + b.value, a.high || b.high); }
inline Number operator-(const Number &a, const Number &b) { return rounded(a.value - b.value, a.high || b.high); }
inline Number operator*(const Number &a, const Number &b) { return rounded(a.value * b.value, a.high || b.high); }
inline Number operator/(const Number &a, const Number &b) { return rounded(a.value / b.value, a.high || b.high); }
inline Number operator+(double a, const Number &b) { return beside(b, a) + b; }
inline Number operator-(double a, const Number &b) { return beside(b, a) - b; }
inline Number operator*(double a, const Number &b) { return beside(b, a) * b; }
inline Number operator/(double a, const Number &b) { return beside(b, a) / b; }
inline Number max(const Number &a, double b) { return a.value < b ? beside(a, b) : a; }

inline Triple operator-(const Triple &a) { return {-a.x, -a.y, -a.z}; }
inline Triple operator+(const Triple &a, const Triple &b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Triple operator-(const Triple &a, const Triple &b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Triple operator*(const Triple &a, const Triple &b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
inline Triple operator*(const Triple &a, const Number &b) { return {a.x * b, a.y * b, a.z * b}; }
inline Triple operator*(const Number &a, const Triple &b) { return b * a; }
inline Triple operator/(const Triple &a, const Number &b) { return {a.x / b, a.y / b, a.z / b}; }
inline bool is_zero(const Triple &v) { return v.x.value == 0 && v.y.value == 0 && v.z.value == 0; }
inline glm::dvec3 value_of(const Triple &v) { return {v.x.value, v.y.value, v.z.value}; }

inline Number dot(const Triple &a, const Triple &b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Number length(const Triple &v) {
    const Number square = dot(v, v);
    return rounded(std::sqrt(square.value), square.high);
}
inline Triple normalize(const Triple &v) { return v / length(v); }
inline Triple cross(const Triple &a, const Triple &b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Triple reflect(const Triple &i, const Triple &n) { return i - 2 * dot(n, i) * n; }
inline Number inversesqrt(const Number &x) { return rounded(1 / std::sqrt(x.value), x.high); }
inline Number exp(const Number &x) { return rounded(std::exp(x.value), x.high); }
inline Number log(const Number &x) { return rounded(std::log(x.value), x.high); }
inline Number pow(const Number &x, const Number &n) {
    if (!(x.value > 0)) {
        return rounded(0, x.high || n.high);
    }
    const Number power = n * rounded(std::log2(x.value), x.high);
    return rounded(std::exp2(power.value), power.high);
}
inline Number mod(const Number &x, const Number &y) {
    const Number ratio = x / y;
    return x - y * Number{std::floor(ratio.value), ratio.high};
}
inline Number smoothstep(const Number &low, const Number &high, const Number &x) {
    const Number share = (x - low) / (high - low);
    const Number t{std::clamp(share.value, 0.0, 1.0), share.high};
    return t * t * (3 - 2 * t);
}

} // namespace sandbox::reference

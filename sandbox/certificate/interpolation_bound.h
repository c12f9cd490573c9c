#pragma once

#include "certificate/jet.h"

/// How far linear interpolation from a triangle's corners may stray from the function itself.
namespace sandbox::certificate {

/// Second derivatives in the weights (u, v), for all points of a triangle.
struct Hessian {
    Interval uu{0}, uv{0}, vv{0};
};
inline Hessian &operator+=(Hessian &sum, const Hessian &more) {
    sum = {sum.uu + more.uu, sum.uv + more.uv, sum.vv + more.vv};
    return sum;
}
inline Hessian operator*(double k, const Hessian &h) { return {k * h.uu, k * h.uv, k * h.vv}; }
inline Hessian hessian_of(const Jet &jet) { return {jet.uu, jet.uv, jet.vv}; }

/// An upper bound of max |f - its linear interpolant| over a triangle, for every f that is continuously differentiable
/// and whose second derivatives, where they exist, are held by `hessian`.
///
/// With H constant the error at weights (l0, l1, l2) is half of the sum of li lj h_ij over the edges, h_ij the second
/// derivative along edge ij, and the largest sum is the squared radius of the smallest circle around the triangle whose
/// squared edges are h_ij: for H = m times the identity, the textbook's m r^2 / 2. Where H varies by h_ij +- p_ij, its
/// three values in Taylor's formula about a point may differ: the sum gains li lj (1 + 2 lk) p_ij.
double interpolation_bound(const Hessian &hessian);

/// Likewise of max(f, 0), which has a kink: f lies in `value`.
double kinked_bound(const Hessian &hessian, const Interval &value);

/// max of a l1 l2 + b l0 l2 + c l0 l1 over weights >= 0 that sum to 1; a, b, c >= 0.
double largest_sum(double a, double b, double c);

} // namespace sandbox::certificate

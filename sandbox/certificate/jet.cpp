#include "certificate/jet.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace sandbox::certificate {
namespace {

double largest(const Linear &a) {
    double all = 0;
    for (const glm::dvec3 &v : a) {
        all = std::max(all, std::abs(v.x) + std::abs(v.y) + std::abs(v.z));
    }
    return all;
}

/// What rounding may do to sums of at most 16 products, each no larger than the largest.
double slack_of(const Linear &a, const Linear &b) { return 64 * one_step * largest(a) * largest(b); }

Interval range(double a, double b, double c, double slack) {
    return {std::min(a, std::min(b, c)) - slack, std::max(a, std::max(b, c)) + slack};
}

Jet dot_at_centroid(const Linear &a, const Linear &b) {
    const double slack = slack_of(a, b);
    const glm::dvec3 a1 = a[1] - a[0], a2 = a[2] - a[0], b1 = b[1] - b[0], b2 = b[2] - b[0];
    const glm::dvec3 p = (a[0] + a[1] + a[2]) / 3.0, q = (b[0] + b[1] + b[2]) / 3.0;
    const auto about = [&](double x) { return Interval{x - slack, x + slack}; };
    return {about(glm::dot(p, q)),
            about(glm::dot(p, b1) + glm::dot(a1, q)),
            about(glm::dot(p, b2) + glm::dot(a2, q)),
            about(2 * glm::dot(a1, b1)),
            about(glm::dot(a1, b2) + glm::dot(a2, b1)),
            about(2 * glm::dot(a2, b2))};
}

} // namespace

Jet OverTriangle::operator()(const Linear &a, const Linear &b) const {
    if (at_centroid) {
        return dot_at_centroid(a, b);
    }
    const double slack = slack_of(a, b);
    const glm::dvec3 a1 = a[1] - a[0], a2 = a[2] - a[0], b1 = b[1] - b[0], b2 = b[2] - b[0];
    const double c0 = glm::dot(a[0], b[0]), c1 = glm::dot(a[1], b[1]), c2 = glm::dot(a[2], b[2]);
    // The middle coefficients of the edges.
    const double c01 = 0.5 * (glm::dot(a[0], b[1]) + glm::dot(a[1], b[0]));
    const double c02 = 0.5 * (glm::dot(a[0], b[2]) + glm::dot(a[2], b[0]));
    const double c12 = 0.5 * (glm::dot(a[1], b[2]) + glm::dot(a[2], b[1]));
    const double uu = 2 * glm::dot(a1, b1), uv = glm::dot(a1, b2) + glm::dot(a2, b1), vv = 2 * glm::dot(a2, b2);
    const auto about = [&](double x) { return Interval{x - slack, x + slack}; };
    return {hull(range(c0, c1, c2, slack), range(c01, c02, c12, slack)),
            range(2 * (c01 - c0), 2 * (c1 - c01), 2 * (c12 - c02), slack),
            range(2 * (c02 - c0), 2 * (c12 - c01), 2 * (c2 - c02), slack),
            about(uu),
            about(uv),
            about(vv)};
}

Interval AtPoint::operator()(const Linear &a, const Linear &b) const {
    const auto at = [&](const Linear &x) { return weights.x * x[0] + weights.y * x[1] + weights.z * x[2]; };
    const double value = glm::dot(at(a), at(b));
    const double slack = slack_of(a, b);
    return {value - slack, value + slack};
}

Jet narrowed(const Jet &over, const Jet &at) {
    constexpr Interval reach{down(-1.0 / 3, 4), up(2.0 / 3, 4)}; // of u and v from the centroid's 1/3
    Jet jet = over;
    jet.u = shared(over.u, at.u + over.uu * reach + over.uv * reach);
    jet.v = shared(over.v, at.v + over.uv * reach + over.vv * reach);
    jet.value = shared(over.value, at.value + jet.u * reach + jet.v * reach);
    return jet;
}

} // namespace sandbox::certificate

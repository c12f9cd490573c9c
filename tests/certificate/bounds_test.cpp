#include "certificate/curves.h"
#include "certificate/interpolation_bound.h"
#include "certificate/jet.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <random>

/// The mathematics that the certificate of `auto` stands on, against closed forms and random points.
namespace sandbox::certificate {
namespace {

class Random {
  public:
    double between(double low, double high) { return low + (high - low) * static_cast<double>(bits_()) / 0x1p32; }
    Interval interval(double low, double high) {
        const double a = between(low, high), b = between(low, high);
        return {std::min(a, b), std::max(a, b)};
    }
    double in(const Interval &x) { return between(x.lo, x.hi); }
    glm::dvec3 vector() { return {between(-1, 1), between(-1, 1), between(-1, 1)}; }
    Linear linear() { return {vector(), vector(), vector()}; }
    glm::dvec3 weights() {
        const double a = between(0, 1), b = between(0, 1);
        return a + b <= 1 ? glm::dvec3(1 - a - b, a, b) : glm::dvec3(a + b - 1, 1 - a, 1 - b);
    }

  private:
    std::mt19937 bits_{7};
};

TEST(Intervals, HoldWhateverTheirMembersGive) {
    Random random;
    for (int i = 0; i < 20000; ++i) {
        const Interval x = random.interval(-2, 2), y = random.interval(-2, 2), z = random.interval(0.1, 3);
        const double a = random.in(x), b = random.in(y), c = random.in(z);
        EXPECT_TRUE((x + y).holds(a + b) && (x - y).holds(a - b) && (x * y).holds(a * b) && (-x).holds(-a));
        EXPECT_TRUE((-1.5 * x).holds(-1.5 * a) && square(x).holds(a * a) && over_positive(x, z).holds(a / c));
    }
}

/// A tenth is no double: its double times 10 must not be all that is held.
TEST(Intervals, StepOutward) {
    const Interval product = Interval{0.1} * Interval{10.0};
    EXPECT_LT(product.lo, 1.0);
    EXPECT_GT(product.hi, 1.0);
    EXPECT_LT(product.hi - product.lo, 1e-15);
}

TEST(Jets, HoldTheDotProductAndItsDerivativesAtEveryPoint) {
    Random random;
    for (int i = 0; i < 2000; ++i) {
        const Linear a = random.linear(), b = random.linear();
        const Jet jet = OverTriangle{}(a, b);
        const glm::dvec3 w = random.weights();
        const auto at = [&](const Linear &x) { return w.x * x[0] + w.y * x[1] + w.z * x[2]; };
        const auto du = [](const Linear &x) { return x[1] - x[0]; };
        const auto dv = [](const Linear &x) { return x[2] - x[0]; };
        EXPECT_TRUE(jet.value.holds(glm::dot(at(a), at(b))));
        EXPECT_TRUE(AtPoint{w}(a, b).holds(glm::dot(at(a), at(b))));
        EXPECT_TRUE(jet.u.holds(glm::dot(du(a), at(b)) + glm::dot(at(a), du(b))));
        EXPECT_TRUE(jet.v.holds(glm::dot(dv(a), at(b)) + glm::dot(at(a), dv(b))));
        EXPECT_TRUE(jet.uu.holds(2 * glm::dot(du(a), du(b))));
        EXPECT_TRUE(jet.uv.holds(glm::dot(du(a), dv(b)) + glm::dot(dv(a), du(b))));
        EXPECT_TRUE(jet.vv.holds(2 * glm::dot(dv(a), dv(b))));
    }
}

/// Products, curves and narrowing, by differences of the function itself: (a.b) / |c| raised to n.
/// A quadratic in (u, v) at a point, and what it is there with its derivatives.
struct Quadratic {
    double c[6]; // 1, u, v, u^2, uv, v^2
    [[nodiscard]] Jet at(double u, double v) const {
        return {c[0] + c[1] * u + c[2] * v + c[3] * u * u + c[4] * u * v + c[5] * v * v,
                c[1] + 2 * c[3] * u + c[4] * v,
                c[2] + c[4] * u + 2 * c[5] * v,
                2 * c[3],
                c[4],
                2 * c[5]};
    }
};

void expect_near(const Interval &found, double expected) {
    EXPECT_TRUE(found.lo <= found.hi && std::abs(found.middle() - expected) < 1e-12)
        << found.lo << " to " << found.hi << ", not " << expected;
}

/// By hand: (fg)'' and (f^2)'' in all directions. A term too few is no wider interval, but another number.
TEST(Jets, HaveTheProductAndTheChainRule) {
    Random random;
    for (int i = 0; i < 200; ++i) {
        Quadratic p{}, q{};
        for (int k = 0; k < 6; ++k) {
            p.c[k] = random.between(-1, 1);
            q.c[k] = random.between(-1, 1);
        }
        const Jet f = p.at(random.between(0, 1), random.between(0, 1)), g = q.at(0.25, 0.5);
        const auto number = [](const Interval &x) { return x.middle(); };
        const Jet product = f * g;
        const double a = number(f.value), au = number(f.u), av = number(f.v);
        const double b = number(g.value), bu = number(g.u), bv = number(g.v);
        expect_near(product.value, a * b);
        expect_near(product.u, au * b + a * bu);
        expect_near(product.v, av * b + a * bv);
        expect_near(product.uu, number(f.uu) * b + 2 * au * bu + a * number(g.uu));
        expect_near(product.uv, number(f.uv) * b + au * bv + av * bu + a * number(g.uv));
        expect_near(product.vv, number(f.vv) * b + 2 * av * bv + a * number(g.vv));
        const Jet squared = compose(Curve{a * a, 2 * a, 2.0}, f);
        expect_near(squared.value, a * a);
        expect_near(squared.u, 2 * a * au);
        expect_near(squared.v, 2 * a * av);
        expect_near(squared.uu, 2 * au * au + 2 * a * number(f.uu));
        expect_near(squared.uv, 2 * au * av + 2 * a * number(f.uv));
        expect_near(squared.vv, 2 * av * av + 2 * a * number(f.vv));
        const Curve both = Curve{a, au, av} * Curve{b, bu, bv};
        expect_near(both.first, au * b + a * bu);
        expect_near(both.second, av * b + 2 * au * bu + a * bv);
        const Jet sum = f + 2.0 * g - f;
        expect_near(sum.uv, 2 * number(g.uv));
        expect_near(sum.vv, 2 * number(g.vv));
        expect_near(sum.u, 2 * bu);
    }
}

TEST(Jets, HoldADifferenceQuotientOfAComposition) {
    Random random;
    int tried = 0;
    for (int i = 0; i < 4000; ++i) {
        const auto near = [&](const glm::dvec3 &middle, double width) {
            return Linear{middle + width * random.vector(), middle + width * random.vector(),
                          middle + width * random.vector()};
        };
        const Linear a = near({1, 0, 0}, 0.3), b = near({0.8, 0.3, 0}, 0.3), c = near({1, 1, 0}, 0.3);
        const double n = random.between(2, 40);
        const auto jet_at = [&](const auto &dot) {
            const Jet length = dot(c, c);
            return dot(a, b) * compose(*inverse_root(length.value), length);
        };
        const Jet base = narrowed(jet_at(OverTriangle{}), jet_at(OverTriangle{.at_centroid = true}));
        const auto curve = power(base.value, n);
        if (!curve) {
            continue;
        }
        ++tried;
        const Jet jet = compose(*curve, base);
        const auto f = [&](double u, double v) {
            const auto at = [&](const Linear &x) { return (1 - u - v) * x[0] + u * x[1] + v * x[2]; };
            return std::pow(std::max(glm::dot(at(a), at(b)) / glm::length(at(c)), 0.0), n);
        };
        const glm::dvec3 w = 0.98 * random.weights() + 0.02 / 3;
        constexpr double h = 1e-3;
        const double u = w.y, v = w.z, here = f(u, v);
        // A quotient is a mean of the derivative nearby; the derivative's bound holds there, too.
        const double slack = 1e-7 * (1 + jet.value.hi) + 2e-9 * (1 + jet.uu.magnitude() + jet.vv.magnitude());
        const auto near_to = [&](const Interval &x, double value) {
            return x.lo - slack <= value && value <= x.hi + slack;
        };
        EXPECT_TRUE(near_to(jet.value, here));
        EXPECT_TRUE(near_to(jet.u, (f(u + h, v) - f(u - h, v)) / (2 * h)));
        EXPECT_TRUE(near_to(jet.v, (f(u, v + h) - f(u, v - h)) / (2 * h)));
        EXPECT_TRUE(near_to(jet.uu, (f(u + h, v) - 2 * here + f(u - h, v)) / (h * h)));
        EXPECT_TRUE(near_to(jet.vv, (f(u, v + h) - 2 * here + f(u, v - h)) / (h * h)));
        EXPECT_TRUE(
            near_to(jet.uv, (f(u + h, v + h) - f(u + h, v - h) - f(u - h, v + h) + f(u - h, v - h)) / (4 * h * h)));
    }
    EXPECT_GT(tried, 3000);
}

/// Every curve, by difference quotients at random numbers of random intervals.
TEST(Curves, HoldTheirFunctionAndItsDerivatives) {
    Random random;
    constexpr double h = 1e-4;
    const auto check = [&](const Curve &curve, const Interval &x, const auto &f) {
        const double at = random.in(x);
        const double slack = 1e-6 * (1 + curve.value.magnitude() + curve.first.magnitude() + curve.second.magnitude());
        EXPECT_LE(curve.value.lo - slack, f(at));
        EXPECT_GE(curve.value.hi + slack, f(at));
        const double inside = std::clamp(at, x.lo + h, std::max(x.lo + h, x.hi - h));
        if (inside + h > x.hi) {
            return;
        }
        const double first = (f(inside + h) - f(inside - h)) / (2 * h);
        const double second = (f(inside + h) - 2 * f(inside) + f(inside - h)) / (h * h);
        EXPECT_TRUE(curve.first.lo - slack <= first && first <= curve.first.hi + slack);
        EXPECT_TRUE(curve.second.lo - slack <= second && second <= curve.second.hi + slack) << second;
    };
    for (int i = 0; i < 5000; ++i) {
        const Interval x = random.interval(0.3, 4);
        const Attenuation k{random.between(0.1, 1), random.between(0, 1), random.between(0, 1)};
        const auto a = [&](double q) { return 1 / (k.constant + k.linear * std::sqrt(q) + k.quadratic * q); };
        check(*inverse_root(x), x, [](double q) { return 1 / std::sqrt(q); });
        check(*attenuation(k, x), x, a);
        check(*attenuation_over_distance(k, x), x, [&](double q) { return a(q) / std::sqrt(q); });
        const Interval cosine = random.interval(-0.5, 1);
        const double n = random.between(2, 20);
        check(*power(cosine, n), cosine, [&](double c) { return std::pow(std::max(c, 0.0), n); });
        check(smooth_step(0.1, 0.6, cosine), cosine, [](double c) {
            const double t = std::clamp((c - 0.1) / 0.5, 0.0, 1.0);
            return t * t * (3 - 2 * t);
        });
    }
}

TEST(Curves, AreNoneWhereNoSecondDerivativeIsBounded) {
    EXPECT_FALSE(inverse_root({0, 1}));
    EXPECT_FALSE(attenuation({0, 0, 1}, {0, 1})); // 1 / 0, but for the floor
    EXPECT_FALSE(attenuation({1, 1, 0}, {0, 1})); // 1 / (1 + d) has a tip at the light
    EXPECT_TRUE(attenuation({1, 0, 1}, {0, 1}).has_value());
    EXPECT_FALSE(power({-0.1, 1}, 1.5));
    EXPECT_FALSE(power({0, 1}, 1));
    EXPECT_TRUE(power({-0.1, 1}, 2).has_value());
}

/// The largest |f - interpolant| over a fine grid of a function of (u, v).
template <class F> double true_error(const F &f, int steps = 60) {
    double most = 0;
    for (int i = 0; i <= steps; ++i) {
        for (int j = 0; i + j <= steps; ++j) {
            const double u = static_cast<double>(i) / steps, v = static_cast<double>(j) / steps;
            most = std::max(most, std::abs((1 - u - v) * f(0, 0) + u * f(1, 0) + v * f(0, 1) - f(u, v)));
        }
    }
    return most;
}

/// Of a quadratic the bound is the error itself: m r^2 / 2 with the smallest circle around the triangle, for one.
TEST(InterpolationBound, IsTheErrorOfAQuadratic) {
    // x^2 + y^2 over an equilateral triangle with edges 1: uu = vv = 2, uv = 1; r^2 = 1 / 3.
    EXPECT_NEAR(interpolation_bound({2.0, 1.0, 2.0}), 1.0 / 3, 1e-6);
    // Over one with a right angle and legs 1: r^2 = 1 / 2.
    EXPECT_NEAR(interpolation_bound({2.0, 0.0, 2.0}), 1.0 / 2, 1e-6);
    Random random;
    for (int i = 0; i < 300; ++i) {
        const double uu = random.between(-2, 2), uv = random.between(-2, 2), vv = random.between(-2, 2);
        const double error =
            true_error([&](double u, double v) { return uu / 2 * u * u + uv * u * v + vv / 2 * v * v; }, 120);
        const double bound = interpolation_bound({uu, uv, vv});
        EXPECT_GE(bound, error);
        // Weights below 0 are dropped, which a saddle does not need.
        const bool definite = uu * vv > uv * uv;
        EXPECT_LE(bound, (definite ? 1.002 : 2.5) * error + 1e-4) << uu << " " << uv << " " << vv;
    }
}

/// Second derivatives that vary: exp and sin, whose ranges over the triangle are known.
TEST(InterpolationBound, HoldsWhereSecondDerivativesVary) {
    Random random;
    for (int i = 0; i < 300; ++i) {
        const double p = random.between(-3, 3), q = random.between(-3, 3);
        const double least = std::exp(std::min({0.0, p, q})), most = std::exp(std::max({0.0, p, q}));
        const Interval e{least, most};
        const double error = true_error([&](double u, double v) { return std::exp(p * u + q * v); });
        EXPECT_GE(interpolation_bound({p * p * e, p * q * e, q * q * e}), error);
        EXPECT_EQ(kinked_bound({p * p * e, p * q * e, q * q * e}, e),
                  interpolation_bound({p * p * e, p * q * e, q * q * e}));
        const double level = random.between(least, most);
        const double kinked =
            true_error([&](double u, double v) { return std::max(std::exp(p * u + q * v) - level, 0.0); });
        EXPECT_GE(kinked_bound({p * p * e, p * q * e, q * q * e}, e - level), kinked);
    }
}

/// max(x, 0) with -1 at one corner and 1 at the others, and the other way round.
TEST(InterpolationBound, IsTheErrorOfAKink) {
    EXPECT_NEAR(kinked_bound({}, {-1, 1}), 0.5, 1e-12);
    EXPECT_NEAR(true_error([](double u, double v) { return std::max(2 * u - 1 + 0 * v, 0.0); }), 0.5, 1e-12);
    EXPECT_NEAR(kinked_bound({}, {-1, 3}), 0.75, 1e-12);
    EXPECT_EQ(kinked_bound({}, {-2, -1}), 0);
}

TEST(InterpolationBound, IsInfiniteWhereNothingIsKnown) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const Interval all{-infinite, infinite}, no_number{std::nan(""), std::nan("")};
    EXPECT_EQ(interpolation_bound({all, 0.0, 0.0}), infinite);
    EXPECT_EQ(interpolation_bound({0.0, 0.0, no_number}), infinite);
}

} // namespace
} // namespace sandbox::certificate

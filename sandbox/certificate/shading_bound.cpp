#include "certificate/shading_bound.h"

#include "certificate/light_factors.h"

#include <algorithm>
#include <array>

namespace sandbox::certificate {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr glm::dvec3 none{0};
/// Red, green and blue of all light and, behind them, of highlights alone: where the body's colour is 0. What lies
/// between is no farther off than the farther of the two.
constexpr std::size_t channels = 6;
using Channels = std::array<Interval, channels>;
constexpr int channel_of(std::size_t i) { return static_cast<int>(i % 3); }

/// Where a cosine that decides a branch lies over the triangle; `roundings`: of how many its float32 value may be off.
enum class Where { below, across, above };
Where where(const Interval &cosine, double roundings) {
    const double width = branch_width * roundings;
    return cosine.lo > width ? Where::above : cosine.hi < -width ? Where::below : Where::across;
}

/// How many times more than one rounding float32 errs in a cone's factor, in shares of body_rounding (choice.cpp): a
/// power by 4e-7 of its exponent, a soft edge by what its width makes of a cosine's rounding.
double cone_noise(const BoundLight &light) {
    const double width = light.cos_inner - light.cos_outer;
    return light.cone ? 1 + 0.25 * light.cone_exponent + (width > 0 ? 0.4 / width : 0) : 1;
}

double largest(const glm::dvec3 &v) { return std::max({v.x, v.y, v.z}); }

/// A light and which of its factors are smooth over the triangle: their errors may cancel, so that they are summed up
/// first.
struct SmoothLight {
    const BoundLight *light;
    Asked factors;
};

/// One side of a triangle.
class Side {
  public:
    Side(const BoundObject &object, const BoundTriangle &triangle)
        : object_(object), triangle_(triangle), over_(object, triangle, {}),
          centroid_(object, triangle, {.at_centroid = true}) {
        known_ = over_.found() && centroid_.found() &&
                 std::ranges::all_of(object.lights, [&](const BoundLight &light) { return add(light); });
        seen_ = known_ ? seen_ : every_light;
    }

    [[nodiscard]] Bound bound(double wanted) const;

  private:
    bool add(const BoundLight &light);
    /// Adds one factor of a light; true: it is smooth, and has been added to hessian_.
    bool add(const Factor<Jet> &factor, const glm::dvec3 &weight, Where side, bool has_kink, bool body);
    [[nodiscard]] std::size_t channels_used() const { return object_.highlight_apart ? channels : channels / 2; }
    [[nodiscard]] Channels smooth_at(const glm::dvec3 &weights) const;
    [[nodiscard]] double error_at(const glm::dvec3 &weights, const std::array<Channels, 3> &corners) const;

    const BoundObject &object_;
    const BoundTriangle &triangle_;
    Lighting<OverTriangle> over_;
    Lighting<OverTriangle> centroid_;
    bool known_ = false;
    std::array<Hessian, channels> hessian_; ///< of all smooth light
    std::vector<SmoothLight> smooth_;
    glm::dvec3 rough_{0}; ///< bounds of what jumps or has a kink
    double body_ = 0, highlight_ = 0;
    LightSet seen_ = 0; ///< as Bound::lights
};

bool Side::add(const Factor<Jet> &factor, const glm::dvec3 &weight, Where side, bool has_kink, bool body) {
    const Interval &value = factor.number.value;
    const Hessian hessian = hessian_of(factor.number);
    if (side == Where::above && factor.smooth) {
        const std::size_t end = body ? channels / 2 : channels_used();
        for (std::size_t c = 0; c < end; ++c) {
            hessian_[c] += weight[channel_of(c)] * hessian;
        }
        return true;
    }
    const bool kink = side == Where::across && has_kink && factor.smooth;
    const double most = kink ? kinked_bound(hessian, value) : std::max(value.hi, 0.0);
    for (int c = 0; c < 3; ++c) {
        rough_[c] += weight[c] != 0 ? weight[c] * most : 0;
    }
    return false;
}

bool Side::add(const BoundLight &light) {
    const auto n_dot_l = over_.n_dot_l(light);
    if (!n_dot_l) {
        return false;
    }
    const Technique &technique = object_.technique;
    const double spread = over_.spread(light), size = over_.longest_normal();
    const Where faced = where(*n_dot_l, spread * size);
    const Where lit = light.diffuse_sign < 0 ? where(-*n_dot_l, spread * size) : faced;
    const Where shown = technique.gate == Gate::none          ? Where::above
                        : technique.gate == Gate::view_facing ? where(over_.n_dot_v(), size)
                                                              : faced;
    const Where ambient = technique.ambient == AmbientWhere::where_lit ? faced : Where::above;
    const bool dark = over_.outside_cone(light);
    const Asked asked{.reach = light.ambient != none && ambient != Where::below && !(dark && light.ambient_fades),
                      .incidence = light.diffuse != none && lit != Where::below && !dark,
                      .highlight = light.specular != none && shown != Where::below && !dark};
    if (!asked.reach && !asked.incidence && !asked.highlight) {
        return true;
    }
    seen_ |= LightSet{1} << light.index;
    LightFactors<Jet> factors = over_.factors(light, asked, &centroid_);
    const double noise = spread * cone_noise(light);
    const glm::dvec3 body = light.ambient * (asked.reach ? 1.0 : 0.0) + light.diffuse * (asked.incidence ? size : 0.0);
    body_ += body != none ? noise * over_.strength(light) * largest(body) : 0;
    Asked smooth{false, false, false};
    if (asked.reach) {
        smooth.reach =
            add(light.ambient_fades ? factors.reach : Factor<Jet>{one<Jet>()}, light.ambient, ambient, false, true) &&
            light.ambient_fades;
    }
    if (asked.incidence) {
        factors.incidence.number = light.diffuse_sign < 0 ? -1.0 * factors.incidence.number : factors.incidence.number;
        smooth.incidence = add(factors.incidence, light.diffuse, lit, true, true);
    }
    if (asked.highlight) {
        highlight_ += noise * largest(light.specular) * std::max(factors.highlight.number.value.hi, 0.0);
        smooth.highlight = add(factors.highlight, light.specular, shown, technique.gate == Gate::times_n_dot_l, false);
    }
    smooth_.push_back({&light, smooth});
    return true;
}

/// The smooth light at a point, but for what is the same at all points.
Channels Side::smooth_at(const glm::dvec3 &weights) const {
    const Lighting<AtPoint> point(object_, triangle_, {weights});
    Channels sum{};
    for (const auto &[light, asked] : smooth_) {
        const LightFactors<Interval> factors = point.factors(*light, asked, nullptr);
        for (std::size_t i = 0; i < channels_used(); ++i) {
            const int c = channel_of(i);
            const bool body = i < channels / 2;
            sum[i] = body && asked.reach ? sum[i] + light->ambient[c] * factors.reach.number : sum[i];
            sum[i] = body && asked.incidence
                         ? sum[i] + light->diffuse_sign * light->diffuse[c] * factors.incidence.number
                         : sum[i];
            sum[i] = asked.highlight ? sum[i] + light->specular[c] * factors.highlight.number : sum[i];
        }
    }
    return sum;
}

double Side::error_at(const glm::dvec3 &weights, const std::array<Channels, 3> &corners) const {
    const Channels here = smooth_at(weights);
    double most = 0;
    for (std::size_t c = 0; c < channels_used(); ++c) {
        const Interval blended = weights.x * corners[0][c] + weights.y * corners[1][c] + weights.z * corners[2][c];
        const double error = (blended - here[c]).magnitude();
        most = error <= most ? most : error;
    }
    return most;
}

/// The error is a smooth function, too, with the same second derivatives. On a grid of 4^k like triangles it is at most
/// its largest value at a grid's point plus what is left between those, which is 4^k times less than on the whole.
Bound Side::bound(double wanted) const {
    Bound result{infinite, body_, highlight_, seen_};
    if (!known_) {
        return result;
    }
    double between = 0, rough = 0;
    for (std::size_t c = 0; c < channels_used(); ++c) {
        const double error = interpolation_bound(hessian_[c]);
        between = error <= between ? between : error;
        rough = std::max(rough, rough_[channel_of(c)]);
    }
    result.interpolation = up(between + rough, 8);
    if (result.interpolation <= wanted || !(rough < wanted) || !(between < infinite)) {
        return result;
    }
    const std::array<Channels, 3> corners{smooth_at({1, 0, 0}), smooth_at({0, 1, 0}), smooth_at({0, 0, 1})};
    double at_points = 0;
    for (int steps = 2; steps <= most_steps; steps *= 2) {
        between /= 4;
        for (int i = 0; i <= steps; ++i) {
            for (int j = 0; i + j <= steps; ++j) {
                const int k = steps - i - j;
                if (i % 2 != 0 || j % 2 != 0 || k % 2 != 0) { // those of earlier grids are known
                    const double error = error_at(glm::dvec3(i, j, k) / static_cast<double>(steps), corners);
                    at_points = error <= at_points ? at_points : error;
                    if (!(at_points + rough <= wanted)) {
                        return result;
                    }
                }
            }
        }
        result.interpolation = std::min(result.interpolation, up(between + at_points + rough, 8));
        if (result.interpolation <= wanted) {
            break;
        }
    }
    return result;
}

BoundTriangle turned(const BoundTriangle &triangle) {
    return {triangle.position, {-triangle.normal[0], -triangle.normal[1], -triangle.normal[2]}};
}

} // namespace

Bound shading_bound(const BoundObject &object, const BoundTriangle &triangle, double wanted) {
    if (!object.two_sided) {
        return Side(object, triangle).bound(wanted);
    }
    if (object.technique.facing == Facing::winding) { // which side is seen is the camera's affair
        const BoundTriangle other = turned(triangle);
        const Bound front = Side(object, triangle).bound(wanted);
        const Bound back = Side(object, other).bound(wanted);
        return {std::max(front.interpolation, back.interpolation), std::max(front.body, back.body),
                std::max(front.highlight, back.highlight), front.lights | back.lights};
    }
    const Lighting<OverTriangle> over(object, triangle, {});
    const Where faces_viewer = over.found() ? where(over.n_dot_v(), over.longest_normal()) : Where::across;
    if (faces_viewer == Where::across) {
        return {.interpolation = infinite};
    }
    const BoundTriangle seen = faces_viewer == Where::above ? triangle : turned(triangle);
    return Side(object, seen).bound(wanted);
}

} // namespace sandbox::certificate

#pragma once

#include "certificate/curves.h"
#include "certificate/shading_bound.h"

#include <optional>

/// The terms of one light, over a triangle or at a point of it, without the branches (N.L > 0, say) that the equation
/// takes outside of them. `Dot` says where: OverTriangle, AtPoint.
namespace sandbox::certificate {

/// Over a triangle: where a factor has a jump, a kink or no bounded derivatives it is not smooth, and its value alone
/// means something.
template <class Number> struct Factor {
    Number number{};
    bool smooth = true;
};

template <class Number> constexpr Number one() {
    Number number{};
    value_of(number) = 1.0;
    return number;
}

template <class Number> struct LightFactors {
    Factor<Number> reach;     ///< attenuation times cone
    Factor<Number> incidence; ///< N.L times that, of either sign
    Factor<Number> highlight; ///< f^n times that; under gate=times-n-dot-l f^n times incidence
};
/// Which of them are asked for; the others stay 0.
struct Asked {
    bool reach = true, incidence = true, highlight = true;
};

template <class Dot> class Lighting {
  public:
    using Number = typename Dot::Number;

    Lighting(const BoundObject &object, const BoundTriangle &triangle, const Dot &dot);

    /// Do N and V keep away from 0? Nothing else may be asked where they do not.
    [[nodiscard]] bool found() const { return found_; }
    [[nodiscard]] const Interval &n_dot_v() const { return value_of(n_dot_v_); }
    /// The cosine; none where the light may lie on the triangle: then nothing is known of that light.
    [[nodiscard]] std::optional<Interval> n_dot_l(const BoundLight &light) const;
    /// How many times more than one rounding float32 turns the direction to the light: it rounds positions by shares of
    /// their distance from the eye. Infinite where the light may lie on the triangle.
    [[nodiscard]] double spread(const BoundLight &light) const;
    /// Does its cone miss every point, in float32, too?
    [[nodiscard]] bool outside_cone(const BoundLight &light) const;
    /// No more than this is left by the distance; infinite where nothing is known.
    [[nodiscard]] double strength(const BoundLight &light) const;
    /// The longest N, at least 1.
    [[nodiscard]] double longest_normal() const;
    /// f before it is cut at 0: R.V or N.H; none where H may not exist.
    [[nodiscard]] std::optional<Number> highlight_cosine(const BoundLight &light) const;
    /// `centroid`: the same there, which narrows what is known of f; else null.
    [[nodiscard]] LightFactors<Number> factors(const BoundLight &light, const Asked &asked,
                                               const Lighting<OverTriangle> *centroid) const;

  private:
    [[nodiscard]] Linear to_light(const BoundLight &light) const;
    /// Of the angle off the cone's axis.
    [[nodiscard]] Number cone_cosine(const BoundLight &light) const;
    [[nodiscard]] Factor<Number> cone(const BoundLight &light) const;
    [[nodiscard]] Factor<Number> highlight_power(const BoundLight &light, const Lighting<OverTriangle> *centroid) const;

    const BoundObject &object_;
    Dot dot_;
    Linear position_, normal_, view_;
    Number inverse_n_ = one<Number>(), inverse_v_ = one<Number>(); ///< 1 / |N|, 1 / |V|; 1 where they are unit
    Number n_dot_v_;                                               ///< of unit vectors
    bool found_ = true;
};

} // namespace sandbox::certificate

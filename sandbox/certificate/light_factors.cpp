#include "certificate/light_factors.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace sandbox::certificate {
namespace {

/// A soft edge narrower than this, in cosines, counts as a jump.
constexpr double narrowest_edge = 1e-6;
constexpr Interval anything{0, std::numeric_limits<double>::infinity()};

Linear negative(const Linear &a) { return {-a[0], -a[1], -a[2]}; }
Linear constant(const glm::dvec3 &a) { return {a, a, a}; }

template <class Number> Factor<Number> rough(const Interval &value) {
    Factor<Number> factor{{}, false};
    value_of(factor.number) = value;
    return factor;
}
template <class Number> Factor<Number> operator*(const Factor<Number> &a, const Factor<Number> &b) {
    return a.smooth && b.smooth ? Factor<Number>{a.number * b.number, true}
                                : rough<Number>(value_of(a.number) * value_of(b.number));
}
template <class Number>
Factor<Number> composed(const std::optional<Curve> &curve, const Number &number, const Interval &otherwise) {
    return curve ? Factor<Number>{compose(*curve, number), true} : rough<Number>(otherwise);
}
template <class Number> std::optional<Number> inverted_root(const Number &square) {
    const auto curve = inverse_root(value_of(square));
    return curve ? std::optional(compose(*curve, square)) : std::nullopt;
}

} // namespace

template <class Dot>
Lighting<Dot>::Lighting(const BoundObject &object, const BoundTriangle &triangle, const Dot &dot)
    : object_(object), dot_(dot), position_(triangle.position), normal_(triangle.normal),
      view_(object.view ? constant(*object.view) : negative(triangle.position)), n_dot_v_(dot(normal_, view_)) {
    const auto make_unit = [&](const Linear &vector, Number &inverse) {
        const auto root = inverted_root(dot_(vector, vector));
        found_ = found_ && root;
        inverse = root.value_or(inverse);
        n_dot_v_ = n_dot_v_ * inverse;
    };
    if (object.unit_normals) {
        make_unit(normal_, inverse_n_);
    }
    if (!object.view) {
        make_unit(view_, inverse_v_);
    }
}

template <class Dot> Linear Lighting<Dot>::to_light(const BoundLight &light) const {
    const glm::dvec3 &p = light.position;
    return light.positional ? Linear{p - position_[0], p - position_[1], p - position_[2]} : constant(-light.travel);
}

template <class Dot> std::optional<Interval> Lighting<Dot>::n_dot_l(const BoundLight &light) const {
    const Linear l = to_light(light);
    const Interval cosine = value_of(dot_(normal_, l)) * value_of(inverse_n_);
    if (!light.positional) {
        return cosine;
    }
    const auto inverse_distance = inverse_root(value_of(dot_(l, l)));
    return inverse_distance ? std::optional(cosine * inverse_distance->value) : std::nullopt;
}

template <class Dot> double Lighting<Dot>::spread(const BoundLight &light) const {
    if (!light.positional) {
        return 1;
    }
    const Linear l = to_light(light);
    const auto longest = [](const Linear &a) {
        return std::max({glm::length(a[0]), glm::length(a[1]), glm::length(a[2])});
    };
    const double nearest = std::sqrt(std::max(value_of(dot_(l, l)).lo, 0.0));
    return 1 + (longest(position_) + glm::length(light.position)) / nearest;
}

template <class Dot> double Lighting<Dot>::strength(const BoundLight &light) const {
    const Linear l = to_light(light);
    const auto fading = light.positional ? attenuation(light.attenuation, value_of(dot_(l, l))) : Curve{1.0, 0.0, 0.0};
    return fading ? fading->value.hi : anything.hi;
}

template <class Dot> double Lighting<Dot>::longest_normal() const {
    return object_.unit_normals ? 1 : std::max(std::sqrt(value_of(dot_(normal_, normal_)).hi), 1.0);
}

template <class Dot>
std::optional<typename Dot::Number> Lighting<Dot>::highlight_cosine(const BoundLight &light) const {
    const bool half_vector = reflection(object_.technique.model).half_vector;
    if (half_vector && object_.technique.half_vector == HalfVector::constant) {
        return dot_(normal_, constant(light.half)) * inverse_n_;
    }
    const Linear l = to_light(light);
    Number n_dot_l = dot_(normal_, l) * inverse_n_;
    Number l_dot_v = dot_(l, view_);
    if (light.positional) {
        const auto inverse_l = inverted_root(dot_(l, l));
        if (!inverse_l) {
            return {};
        }
        n_dot_l = n_dot_l * *inverse_l;
        l_dot_v = l_dot_v * *inverse_l;
    }
    l_dot_v = object_.view ? l_dot_v : l_dot_v * inverse_v_;
    if (!half_vector) {
        return 2.0 * (n_dot_l * n_dot_v_) - l_dot_v;
    }
    Number square = 2.0 * l_dot_v; // |L + V|^2
    value_of(square) = value_of(square) + 2.0;
    const auto inverse_h = inverted_root(square);
    return inverse_h ? std::optional((n_dot_l + n_dot_v_) * *inverse_h) : std::nullopt;
}

template <class Dot> typename Dot::Number Lighting<Dot>::cone_cosine(const BoundLight &light) const {
    const Linear l = to_light(light);
    Number c = dot_(negative(l), constant(light.travel)) * inverted_root(dot_(l, l)).value_or(one<Number>());
    value_of(c) = shared(value_of(c), {-1, 1});
    return c;
}

template <class Dot> bool Lighting<Dot>::outside_cone(const BoundLight &light) const {
    return light.cone && value_of(cone_cosine(light)).hi < light.cos_outer - branch_width * spread(light);
}

template <class Dot> Factor<typename Dot::Number> Lighting<Dot>::cone(const BoundLight &light) const {
    const Number c = cone_cosine(light);
    const Interval &range = value_of(c);
    const double width = branch_width * spread(light);
    if (range.hi < light.cos_outer - width) {
        return {};
    }
    const auto raised = power(range, light.cone_exponent);
    const Interval most{0, raised ? raised->value.hi : 1};
    if (range.lo > light.cos_inner + width) {
        return composed(raised, c, most);
    }
    const bool soft = light.cos_inner - light.cos_outer > narrowest_edge;
    return soft && raised ? composed(smooth_step(light.cos_outer, light.cos_inner, range) * *raised, c, most)
                          : rough<Number>(most);
}

template <class Dot>
Factor<typename Dot::Number> Lighting<Dot>::highlight_power(const BoundLight &light,
                                                            const Lighting<OverTriangle> *centroid) const {
    auto f = highlight_cosine(light);
    if (!f) {
        return rough<Number>(object_.unit_normals ? Interval{0, 1} : anything);
    }
    if constexpr (std::is_same_v<Dot, OverTriangle>) {
        const auto at = centroid != nullptr ? centroid->highlight_cosine(light) : std::nullopt;
        f = at ? narrowed(*f, *at) : *f;
    }
    Interval &range = value_of(*f);
    range.hi = object_.unit_normals ? std::min(range.hi, 1.0) : range.hi;
    range.lo = std::min(range.lo, range.hi);
    const double most = object_.exponent == 0 ? 1 : up(std::pow(std::max(range.hi, 0.0), object_.exponent), 4);
    return composed(power(range, object_.exponent), *f, {0, most});
}

template <class Dot>
LightFactors<typename Dot::Number> Lighting<Dot>::factors(const BoundLight &light, const Asked &asked,
                                                          const Lighting<OverTriangle> *centroid) const {
    const Linear l = to_light(light);
    const bool times_n_dot_l = object_.technique.gate == Gate::times_n_dot_l;
    const Number square_distance = light.positional ? dot_(l, l) : one<Number>();
    const Interval &range = value_of(square_distance);
    const Factor<Number> spot = light.cone ? cone(light) : Factor<Number>{one<Number>()};
    LightFactors<Number> factors;
    if (asked.reach || (asked.highlight && !times_n_dot_l)) {
        factors.reach = light.positional ? composed(attenuation(light.attenuation, range), square_distance, anything)
                                         : Factor<Number>{one<Number>()};
        factors.reach = light.cone ? factors.reach * spot : factors.reach;
    }
    if (asked.incidence || (asked.highlight && times_n_dot_l)) {
        factors.incidence.number = dot_(normal_, l);
        if (object_.unit_normals) {
            factors.incidence.number = factors.incidence.number * inverse_n_;
        }
        if (light.positional) {
            factors.incidence = factors.incidence * composed(attenuation_over_distance(light.attenuation, range),
                                                             square_distance, anything);
        }
        factors.incidence = light.cone ? factors.incidence * spot : factors.incidence;
    }
    if (asked.highlight) {
        factors.highlight = highlight_power(light, centroid) * (times_n_dot_l ? factors.incidence : factors.reach);
    }
    return factors;
}

template class Lighting<OverTriangle>;
template class Lighting<AtPoint>;

} // namespace sandbox::certificate

#include "reference/medium_stage.h"

#include "reference/half_numbers.h"
#include "scene/light_kind.h"
#include "shading/features.h"
#include "shading/object_lights.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>
#include <vector>

namespace sandbox::reference {

namespace {

constexpr Number one{1, false};

/// One pixel. The members are the text's variables and uniforms, by their names there.
class MediumStage {
  public:
    MediumStage(const Setup &setup, const Object &object, const BaseColor &base, const Varyings &varyings)
        : setup_(setup), technique_(setup.technique), object_(object), material_(object.material), base_(base),
          varyings_(varyings), has_base_(base.texture != nullptr || base.checker != nullptr || varyings.colored),
          shininess_(keep(Kept::shininess, raised_exponent(setup, material_.shininess))) {}

    glm::dvec3 color() {
        P_ = keep(Kept::v_position, varyings_.position);
        find_vectors();
        find_light();
        if (!has_base_) {
            return value_of(hybrid() ? vertex_light() + sum_ : sum_);
        }
        const bool apart = !material_.texture_modulates_specular; // the highlight is not multiplied by the base
        Triple color = hybrid() ? (apart ? base() * vertex_light() + sum_ : base() * (vertex_light() + sum_))
                                : (apart ? base() * sum_ + specular_ : base() * sum_);
        return value_of(any(material_.emission) ? color + keep(Kept::emission, material_.emission) : color);
    }

  private:
    static bool any(const glm::dvec3 &v) { return v != glm::dvec3(0); }
    /// What is stored under a name is as precise as that is declared.
    [[nodiscard]] Number keep(Kept name, const Number &value) const {
        return rounded(value.value, setup_.high.test(static_cast<std::size_t>(name)));
    }
    [[nodiscard]] Triple keep(Kept name, const Triple &v) const {
        return {keep(name, v.x), keep(name, v.y), keep(name, v.z)};
    }
    [[nodiscard]] Number keep(Kept name, double value) const { return keep(name, Number{value, true}); }
    [[nodiscard]] Triple keep(Kept name, const glm::dvec3 &v) const { return keep(name, rounded(v, true)); }

    [[nodiscard]] bool hybrid() const { return technique_.frequency == Frequency::hybrid; }
    [[nodiscard]] bool interpolated() const { return technique_.frequency == Frequency::interpolated_vectors; }
    [[nodiscard]] Triple vertex_light() const {
        return keep(Kept::v_light, varyings_.light + (has_base_ ? glm::dvec3(0) : material_.emission));
    }

    void find_vectors() {
        const Triple normal = keep(Kept::v_normal, varyings_.normal);
        const bool unit = technique_.renormalize == Renormalize::on && technique_.normals != Normals::unnormalized;
        N_ = keep(Kept::N, unit && !is_zero(normal) ? normalize(normal) : normal);
        V_ = keep(Kept::V, setup_.orthographic || technique_.viewer == Viewer::infinite
                               ? keep(Kept::view_direction, setup_.view_axis)
                               : normalize(to_eye()));
        const bool away = technique_.facing == Facing::view ? dot(N_, V_).value < 0 : varyings_.side == Side::back;
        N_ = object_.two_sided && away ? -N_ : N_;
        R_ = mirrors_view(technique_.model) ? keep(Kept::R, reflect(-V_, N_)) : R_;
    }

    [[nodiscard]] Triple to_eye() const {
        if (interpolated()) {
            return keep(Kept::v_view, varyings_.view);
        }
        return any(setup_.origin) ? keep(Kept::eye, -setup_.origin) - P_ : -P_;
    }

    /// The constant ambient light, then that of every light, kind by kind.
    void find_light() {
        glm::dvec3 ambient = setup_.ambient;
        for (const LightSetup &light : setup_.lights) {
            if (!ambient_with_light(light.light, technique_)) {
                ambient += light.light.color * light.light.ambient;
            }
        }
        ambient = material_.ambient * ambient + (has_base_ ? glm::dvec3(0) : material_.emission);
        sum_ = hybrid() ? Triple{} : keep(Kept::sum, keep(Kept::ambient, ambient));
        for (const LightKind &kind : light_kinds) {
            std::vector<std::size_t> lights;
            for (std::size_t i = 0; i < setup_.lights.size(); ++i) {
                if (drawn_type(setup_.lights[i].light) == kind.type) {
                    lights.push_back(i);
                }
            }
            bool ambient = false, diffuse = false, specular = false; // terms of the kind that fade
            for (const std::size_t i : lights) {
                const Light &light = setup_.lights[i].light;
                const ShiningTerms shines = terms_here(light);
                ambient = ambient || (shines.ambient && light.attenuate_ambient && fades(light));
                diffuse = diffuse || shines.diffuse;
                specular = specular || (shines.specular && !specular_apart());
            }
            for (const std::size_t i : lights) {
                add_light(i, int{ambient} + int{diffuse} + int{specular} == 1);
            }
        }
    }

    /// A term that a factor of 0 takes away is not there.
    [[nodiscard]] ShiningTerms terms_here(const Light &light) const {
        const ShiningTerms shines = terms_on(object_, light, technique_.model);
        return {.ambient = shines.ambient && !hybrid() && ambient_with_light(light, technique_),
                .diffuse = shines.diffuse && !hybrid(),
                .specular = shines.specular};
    }
    [[nodiscard]] bool specular_apart() const {
        return has_base_ && !material_.texture_modulates_specular && !hybrid();
    }

    /// light_terms.glsl. `alone`: one term fades, so that the text needs no brackets around it.
    void add_light(std::size_t index, bool alone) {
        const LightSetup &setup = setup_.lights[index];
        const Light &light = setup.light;
        const ShiningTerms shines = terms_here(light);
        if (!shines.ambient && !shines.diffuse && !shines.specular) {
            return;
        }
        const bool attenuated = has_position(light) && light.attenuation != Attenuation{};
        find_direction(index, attenuated);
        const Number a = attenuated ? keep(Kept::a, attenuation(index)) : one;
        const Number times = a * (has_cone(light) ? keep(Kept::s, cone(setup)) : one);
        const Number first = alone ? times : one;
        const Number n_dot_l = keep(Kept::n_dot_l, dot(N_, L_));
        Triple plain, faded; // zero: adding that changes nothing
        if (shines.ambient) {
            const bool dark = technique_.ambient == AmbientWhere::where_lit && !(n_dot_l.value > 0);
            const Triple ambient =
                (dark ? Number{} : one) * keep(Kept::light_ambient, material_.ambient * light.color * light.ambient);
            (light.attenuate_ambient && fades(light) ? faded : plain) = ambient;
            faded = first * faded;
        }
        if (shines.diffuse) {
            const bool unnegated = technique_.direction == DirectionSign::unnegated_diffuse && !has_position(light);
            const double over = technique_.normalisation == Normalisation::blinn_phong ? std::numbers::inv_pi : 1;
            faded = faded + first *
                                keep(Kept::light_diffuse, material_.diffuse * light.color * (light.diffuse * over)) *
                                max(unnegated ? -n_dot_l : n_dot_l, 0);
        }
        if (shines.specular) {
            const double scale = light.specular * highlight_scale(setup_, material_.shininess);
            const Triple specular = keep(Kept::light_specular, material_.specular * light.color * scale);
            const Number highlight = keep(Kept::highlight, gated_highlight(index, n_dot_l));
            if (specular_apart()) {
                specular_ = keep(Kept::specular, specular_ + times * (specular * highlight));
            } else {
                faded = faded + first * specular * highlight;
            }
        }
        sum_ = keep(Kept::sum, sum_ + (plain + (alone ? one : times) * faded));
    }

    /// light_position.glsl and light_directional.glsl
    void find_direction(std::size_t index, bool attenuated) {
        const LightSetup &light = setup_.lights[index];
        if (!has_position(light.light)) {
            L_ = keep(Kept::L, -keep(Kept::direction, light.travel));
        } else if (interpolated()) {
            L_ = keep(Kept::L, normalize(keep(Kept::v_L, varyings_.vectors[index].l)));
            d_ = keep(Kept::v_distance, varyings_.vectors[index].d);
        } else {
            const Triple position = keep(Kept::position, light.position - setup_.origin);
            const Triple to_light = keep(Kept::to_light, position - P_);
            const Number distance = length(to_light);
            d_ = attenuated ? keep(Kept::d, distance) : distance;
            L_ = keep(Kept::L, is_zero(to_light) ? N_ : to_light / d_);
        }
    }

    /// light_attenuation.glsl
    [[nodiscard]] Number attenuation(std::size_t index) const {
        if (technique_.attenuation == AttenuationAt::interpolated) {
            return keep(Kept::v_attenuation, varyings_.vectors[index].a);
        }
        const Attenuation &k = setup_.lights[index].light.attenuation;
        const bool given = technique_.attenuation == AttenuationAt::distance_interpolated;
        const Number d = given ? keep(Kept::v_distance, varyings_.vectors[index].d) : d_;
        Number denominator = keep(Kept::coefficients, k.constant);
        if (k.linear != 0) {
            denominator = denominator + keep(Kept::coefficients, k.linear) * d;
        }
        if (k.quadratic != 0) {
            denominator = denominator + keep(Kept::coefficients, k.quadratic) * d * d;
        }
        return 1 / max(denominator, 1e-6);
    }

    /// light_cone.glsl
    [[nodiscard]] Number cone(const LightSetup &setup) const {
        const Light &light = setup.light;
        const Triple direction = keep(Kept::direction, setup.travel);
        const Number c = keep(Kept::c, dot(-L_, direction));
        const Triple sine = keep(Kept::sine, cross(L_, direction));
        Number s = keep(Kept::s, edge(setup, c, sine));
        if (light.exponent == 0) {
            return s;
        }
        const Number exponent = keep(Kept::exponent, light.exponent);
        if (asks_for_stable_power(technique_, light.exponent)) {
            return s * keep(Kept::falloff, c.value > 0 ? stable_power(dot(sine, sine), 0.5 * exponent) : Number{});
        }
        return s * keep(Kept::falloff, pow(max(c, 0), exponent));
    }

    [[nodiscard]] Number edge(const LightSetup &setup, const Number &c, const Triple &sine) const {
        const Light &light = setup.light;
        const Number outer = keep(Kept::cone, setup.cos_outer);
        const Number inner = keep(Kept::cone, setup.cos_inner);
        if (!is_narrow_cone(light)) {
            return has_soft_edge(light) ? smoothstep(outer, inner, c) : (c.value < outer.value ? Number{} : one);
        }
        const double sine_of_cutoff = std::sin(glm::radians(light.cutoff_degrees));
        const Number sin2 = keep(Kept::cone, sine_of_cutoff * sine_of_cutoff);
        const Number inside = c.value > 0.5 ? (sin2 - dot(sine, sine)) / (c + outer) : c - outer;
        if (!has_soft_edge(light)) {
            return inside.value < 0 ? Number{} : one;
        }
        const Number sharpness = keep(Kept::cone, 1 / std::max(setup.cos_inner - setup.cos_outer, 1e-30));
        return smoothstep(Number{}, one, inside * sharpness);
    }

    [[nodiscard]] Number gated_highlight(std::size_t index, const Number &n_dot_l) const {
        const Gate gate = technique_.gate;
        const bool shut = (gate == Gate::light_facing && !(n_dot_l.value > 0)) ||
                          (gate == Gate::view_facing && !(dot(N_, V_).value > 0));
        if (shut) {
            return {};
        }
        const Number open = highlight(index);
        return gate == Gate::times_n_dot_l ? max(n_dot_l, 0) * open : open;
    }

    [[nodiscard]] Number highlight(std::size_t index) const {
        const double n = raised_exponent(setup_, material_.shininess);
        const Exponent kind = exponent_kind(technique_, technique_.normals, n);
        if (kind == Exponent::zero) {
            return one;
        }
        if (mirrors_view(technique_.model)) {
            return interpolated() ? phong(normalize(keep(Kept::v_R, varyings_.vectors[index].r)), V_, kind)
                                  : phong(R_, L_, kind);
        }
        const LightSetup &light = setup_.lights[index];
        const bool same_everywhere =
            technique_.half_vector == HalfVector::constant ||
            (!has_position(light.light) && (setup_.orthographic || technique_.viewer == Viewer::infinite));
        return blinn_phong(keep(Kept::H, same_everywhere  ? keep(Kept::half_vector, light.constant_half)
                                         : interpolated() ? keep(Kept::v_H, varyings_.vectors[index].h)
                                                          : L_ + V_),
                           kind);
    }

    /// reflection_phong.glsl
    [[nodiscard]] Number phong(const Triple &R, const Triple &L, Exponent kind) const {
        const Number cosine = dot(R, L);
        if (kind == Exponent::stable) {
            const Triple chord = keep(Kept::chord, R - L);
            return cosine.value > 0 ? stable_power(0.5 * dot(chord, chord), shininess_) : Number{};
        }
        return kind == Exponent::one ? max(cosine, 0) : pow(max(cosine, 0), shininess_);
    }

    /// reflection_blinn_phong.glsl
    [[nodiscard]] Number blinn_phong(const Triple &H, Exponent kind) const {
        if (technique_.power == Power::naive) {
            return pow(max(dot(N_, normalize(H)), 0), shininess_);
        }
        const Number h2 = keep(Kept::h2, dot(H, H));
        if (kind == Exponent::stable) {
            const Triple sine = keep(Kept::sine, cross(N_, H));
            if (!(h2.value > 0)) {
                return one;
            }
            return dot(N_, H).value > 0 ? stable_power(dot(sine, sine) / h2, 0.5 * shininess_) : Number{};
        }
        const Number f = keep(Kept::f, h2.value > 0 ? max(dot(N_, H), 0) * inversesqrt(h2) : one);
        return kind == Exponent::one ? f : pow(f, shininess_);
    }

    /// power_stable.glsl
    [[nodiscard]] Number stable_power(const Number &share, const Number &n) const {
        const Number x = keep(Kept::x, share);
        Number sum = 1.0 / 6 + x / beside(x, 7);
        for (const double k : {5.0, 4.0, 3.0, 2.0, 1.0}) {
            sum = 1 / k + x * sum;
        }
        const Number series = keep(Kept::series, -x * sum);
        return exp(n * (x.value < 0.125 ? series : log(max(1 - x, 1e-30))));
    }

    [[nodiscard]] Triple base() const {
        const Triple vertices = keep(Kept::v_color, varyings_.color);
        if (base_.checker == nullptr && base_.texture == nullptr) {
            return keep(Kept::base, vertices);
        }
        const Triple own = keep(Kept::base, base_.checker != nullptr ? checker_color() : texture_color());
        return varyings_.colored ? keep(Kept::base, own * vertices) : own;
    }

    [[nodiscard]] Triple texture_color() const {
        const Number u = keep(Kept::v_uv, varyings_.uv.x);
        const Number v = keep(Kept::v_uv, varyings_.uv.y);
        return rounded(base_.color_at({u.value, v.value}, {}), u.high);
    }

    /// base_checker.glsl
    [[nodiscard]] Triple checker_color() const {
        const Checker &checker = *base_.checker;
        const auto uniform = [&](double value) { return keep(Kept::checker, value); };
        const double below = checker.cells / 2.0;
        const Triple position = keep(Kept::v_object_position, varyings_.object_position);
        const auto cell = [&](const Number &p) {
            const Number moved =
                p * uniform(checker.cells / (2 * base_.half_extent)) + uniform(below - std::round(below));
            const Number whole = Number{std::floor(moved.value), moved.high} + uniform(std::round(below));
            return Number{std::clamp(whole.value, 0.0, checker.cells - 1.0), whole.high};
        };
        const Number two{2, false};
        const bool first = mod(cell(position.x) + cell(position.y) + cell(position.z), two).value < 0.5;
        return keep(Kept::checker, checker.colors[first ? 0 : 1]);
    }

    const Setup &setup_;
    const Technique &technique_;
    const Object &object_;
    const Material &material_;
    const BaseColor &base_;
    const Varyings &varyings_;
    bool has_base_;
    Number shininess_;
    Triple P_, N_, V_, R_, L_, sum_, specular_;
    Number d_;
};

} // namespace

glm::dvec3 medium_color(const Setup &setup, const Object &object, const BaseColor &base, const Varyings &varyings) {
    return MediumStage(setup, object, base, varyings).color();
}

} // namespace sandbox::reference

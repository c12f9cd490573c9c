#include "reference/branches.h"

#include "reference/raster.h"
#include "scene/light_kind.h"
#include "shading/object_lights.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <optional>

namespace sandbox::reference {

namespace {

constexpr double negligible_jump = 1e-6;  ///< a smaller jump shows in no figure
constexpr double negligible_noise = 1e-5; ///< a colour's change by rounding that is less is within every bound
constexpr double far_from_a_branch = 0.1; ///< N.L and cosines change less over edge_width
constexpr double steep_exponent = 0.5;    ///< f^n with a smaller n leaves 0 like a jump
constexpr double short_vector = 0.25;     ///< float32 rounds it at least four times as coarsely as a unit vector
constexpr double blurred_angle = 1e-3;    ///< radians: a rounding of a small angle's cosine

double largest(const glm::dvec3 &v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// By how many times its own length float32 rounds a shortened vector more than a unit one.
double excess(double length) { return 1 / std::clamp(length, rounding, 1.0) - 1; }

/// The two positions' lengths, which are what float32 rounds of their difference.
double lengths_of(const Setup &setup, const LightSetup &light, const glm::dvec3 &position) {
    return has_position(light.light) ? glm::length(position - setup.origin) + glm::length(light.position - setup.origin)
                                     : 0;
}

/// The same as multiples of the distance.
double spread(const Setup &setup, const LightSetup &light, const glm::dvec3 &position, double d) {
    return lengths_of(setup, light, position) / std::max(d, 1e-300);
}

/// The angle between two unit vectors, exact for small ones, too.
double angle_between(const glm::dvec3 &a, const glm::dvec3 &b) {
    return 2 * std::asin(std::min(glm::length(a - b) / 2, 1.0));
}

/// Of a unit vector with any of these directions, give or take `slack` radians; 0 where none is within 90 degrees.
double largest_cosine(const glm::dvec3 &v, const Directions &directions, double slack) {
    const double angle = std::max(angle_between(v, directions.axis) - directions.angle - slack, 0.0);
    return std::max(std::cos(angle), 0.0);
}

} // namespace

Directions directions_to(const glm::dvec3 &middle, double radius) {
    const double distance = glm::length(middle);
    return distance > radius ? Directions{unit(middle), std::asin(radius / distance)} : Directions{};
}

/// The branches at one point. Its neighbours are worked out only where a branch is close.
class Branches {
  public:
    Branches(const Sampler &sampler, Terms terms, const SurfacePoint &here)
        : sampler_(sampler), setup_(sampler.setup_), object_(sampler.object_), terms_(terms), here_(here) {}

    Doubts doubts() {
        view_branch();
        for (std::size_t i = 0; i < setup_.lights.size(); ++i) {
            light_branches(i);
        }
        return doubts_;
    }

  private:
    /// What one light adds to the colour at most, terms apart.
    struct Amounts {
        glm::dvec3 ambient{0}, diffuse{0}, highlight{0};
    };

    void view_branch() {
        const auto n_dot_v = [](const SurfacePoint &p) { return glm::dot(p.raw_normal, p.view); };
        const bool gate = setup_.technique.gate == Gate::view_facing;
        const bool turned = object_.two_sided && setup_.technique.facing == Facing::view;
        if ((!turned && !gate) || !close(n_dot_v, 2 * rounding / here_.normal_length)) {
            return;
        }
        if (turned) {
            doubt_turning();
        }
        for (std::size_t i = 0; gate && adds_highlight() && i < setup_.lights.size(); ++i) {
            const LightTerms terms = sampler_.terms_at(here_, i);
            doubts_.jump.highlight += amounts(i, terms.vectors.a * terms.s, terms.f_power).highlight;
        }
    }

    void light_branches(std::size_t i) {
        const LightSetup &light = setup_.lights[i];
        const LightVectors vectors = sampler_.vectors(here_, i);
        if (direction_is_rounding(setup_, light, here_.position)) {
            const auto [length, radius] = lost_direction(setup_, light, here_.position);
            const Directions to_light = directions_to(length * vectors.l, radius);
            return doubt_direction(i, attenuation_bound(light, vectors.d), to_light,
                                   highlight_directions(vectors, to_light));
        }
        if (has_short_normal() || std::min(vectors.l_length, vectors.highlight_length) < short_vector) {
            doubt_short_vectors(i, vectors);
        }
        const double lengths = spread(setup_, light, here_.position, vectors.d);
        const double shortness = 1 / here_.normal_length + excess(vectors.l_length);
        const double noise = rounding * (shortness + lengths);
        // A product of exact zeros has no rounding: a floor under a horizontal directional light is not in doubt.
        const double dot_noise =
            rounding * (glm::dot(glm::abs(here_.normal), glm::abs(vectors.l)) * shortness + lengths);
        const auto n_dot_l = [&](const SurfacePoint &p) { return glm::dot(p.normal, sampler_.vectors(p, i).l); };
        const double middle = (light.cos_inner + light.cos_outer) / 2;
        const auto beyond_cone = [&](const SurfacePoint &p) {
            return glm::dot(-sampler_.vectors(p, i).l, light.travel) - middle;
        };
        const double in_cone = cone_noise(light, rounding * shortness, rounding * lengths);
        const double edge = light.cos_inner - light.cos_outer; // one that rounding spans is as good as hard
        const bool steps = light.cone && in_cone > far_from_a_branch * edge;
        const bool at_cone = steps && close(beyond_cone, in_cone + edge / 2);
        const bool gated = adds_highlight() && setup_.technique.gate == Gate::light_facing;
        const bool where_lit = adds_body() && setup_.technique.ambient == AmbientWhere::where_lit;
        const bool at_gate = (gated || where_lit) && close(n_dot_l, dot_noise);
        if (at_cone || at_gate) {
            doubt_light(i, at_cone, at_gate && gated, at_gate && where_lit);
        }
        doubt_steep_highlight(i, noise);
    }

    /// Of the cosine, where L is turned by `noise` and `turn`, and the dot product rounded by `noise`; where programs
    /// compare sines, it is not.
    static double cone_noise(const LightSetup &light, double noise, double turn) {
        const double sine = std::sqrt(std::max(1 - light.cos_outer * light.cos_outer, 0.0));
        const double turned = noise + turn;
        return turned * (sine + turned) + (is_narrow_cone(light.light) ? 0 : noise);
    }

    template <class Quantity> bool close(const Quantity &quantity, double noise) {
        const double q = quantity(here_);
        if (std::abs(q) > far_from_a_branch) {
            return false;
        }
        if (!right_) {
            right_ = sampler_.point_at(edge_width, 0);
            below_ = sampler_.point_at(0, edge_width);
        }
        return std::abs(q) < std::abs(quantity(*right_) - q) + std::abs(quantity(*below_) - q) + noise;
    }

    /// `reach`: attenuation and cone; the highlight's factor is `f_power`, the diffuse one 1.
    Amounts amounts(std::size_t i, double reach, double f_power) const {
        const Light &light = setup_.lights[i].light;
        const Material &material = object_.material;
        const double ambient = light.ambient * (light.attenuate_ambient ? reach : 1);
        Amounts amount;
        if (adds_body()) {
            amount.ambient = material.ambient * light.color * ambient;
            amount.diffuse = material.diffuse * light.color * (light.diffuse * reach);
        }
        if (adds_highlight()) {
            const double scale = highlight_scale(setup_, object_.material.shininess);
            amount.highlight = material.specular * light.color * (light.specular * f_power * reach * scale);
        }
        return amount;
    }

    /// What passes the cone or the gate and what does not is in doubt: it jumps by all that the light adds there.
    void doubt_light(std::size_t i, bool at_cone, bool at_gate, bool where_lit) {
        const LightTerms terms = sampler_.terms_at(here_, i);
        const Light &light = setup_.lights[i].light;
        const Amounts amount = amounts(i, terms.vectors.a * (at_cone ? terms.s_uncut : terms.s), terms.f_power);
        if (at_cone) {
            doubts_.jump.body += amount.diffuse * std::max(terms.n_dot_l, 0.0);
            doubts_.jump.body += light.attenuate_ambient ? amount.ambient : glm::dvec3(0);
        }
        if (at_gate || (at_cone && terms.gate)) {
            doubts_.jump.highlight += amount.highlight;
        }
        doubts_.jump.body += where_lit ? amount.ambient : glm::dvec3(0);
    }

    /// For small n, f^n rises so steeply at f = 0 that a rounding of f is a jump of the highlight.
    void doubt_steep_highlight(std::size_t i, double noise) {
        const double n = raised_exponent(setup_, object_.material.shininess);
        if (!adds_highlight() || n == 0 || n > steep_exponent) {
            return;
        }
        const auto f = [&](const SurfacePoint &p) {
            const auto [a, b] = highlight_vectors(setup_.technique.model, sampler_.vectors(p, i), p.normal, p.view);
            return glm::dot(a, b);
        };
        if (close(f, noise)) {
            const LightTerms terms = sampler_.terms_at(here_, i);
            doubts_.jump.highlight += amounts(i, terms.gate ? terms.vectors.a * terms.s : 0, 1).highlight;
        }
    }

    void doubt_turning() {
        SurfacePoint turned = here_;
        turned.normal = -here_.normal;
        const Reflected before = sampler_.reflect(terms_, here_);
        const Reflected after = sampler_.reflect(terms_, turned);
        doubts_.jump.body += glm::abs(before.body - after.body);
        doubts_.jump.highlight += glm::abs(before.highlight - after.highlight);
    }

    /// The largest attenuation that a distance within rounding of `d` gives.
    double attenuation_bound(const LightSetup &light, double d) const {
        const double nearest = std::max(d - rounding * lengths_of(setup_, light, here_.position), 0.0);
        return has_position(light.light) ? attenuation(light.light.attenuation, nearest) : 1;
    }

    /// R turns as L does; H points to L + V.
    [[nodiscard]] Directions highlight_directions(const LightVectors &vectors, const Directions &to_light) const {
        if (setup_.technique.model == Model::phong) {
            return {vectors.r, to_light.angle};
        }
        return setup_.technique.half_vector == HalfVector::exact
                   ? directions_to(vectors.l + here_.view, 2 * std::sin(to_light.angle / 2))
                   : Directions{};
    }

    /// L may be any of these, R or H any of those: what depends on them may have any value that the cone, the side that
    /// is lit and the highlight's width let pass.
    void doubt_direction(std::size_t i, double reach, const Directions &to_light, const Directions &highlight = {}) {
        const LightSetup &light = setup_.lights[i];
        const double slack = blurred_angle + 2 * rounding * (1 / here_.normal_length + excess(here_.view_length));
        const Directions cone =
            light.cone ? Directions{-light.travel, glm::radians(light.light.cutoff_degrees)} : Directions{};
        const glm::dvec3 n = unit(here_.normal);
        const bool where_lit = setup_.technique.ambient == AmbientWhere::where_lit;
        if (where_lit && !light.light.attenuate_ambient && largest_cosine(n, to_light, slack) > 0) {
            doubts_.rounding.body += amounts(i, reach, 0).ambient; // it does not ask for the cone
        }
        if (angle_between(to_light.axis, cone.axis) > to_light.angle + cone.angle + slack) {
            return;
        }
        const double incidence = std::min(largest_cosine(n, to_light, slack), largest_cosine(n, cone, slack));
        const bool phong = setup_.technique.model == Model::phong;
        double f = largest_cosine(phong ? here_.view : n, highlight, slack);
        // H lies within 90 degrees of V; where the gate asks for light, R lies within 90 degrees of N.
        const bool in_half = phong ? asks_for_light() : setup_.technique.half_vector == HalfVector::exact;
        if (in_half && glm::dot(n, here_.view) < 0) {
            f = std::min(f, glm::length(glm::cross(n, here_.view)) + slack);
        }
        const Amounts amount = amounts(i, reach, std::pow(f, raised_exponent(setup_, object_.material.shininess)));
        if (light.light.attenuate_ambient && (where_lit ? incidence > 0 : fades(light.light))) {
            doubts_.rounding.body += amount.ambient;
        }
        doubts_.rounding.body += amount.diffuse * (incidence * std::max(glm::length(here_.normal), 1.0));
        doubts_.rounding.highlight += incidence > 0 || !asks_for_light() ? amount.highlight : glm::dvec3(0);
    }

    [[nodiscard]] bool has_short_normal() const {
        return !sampler_.keeps_normal_lengths() && here_.normal_length < short_vector;
    }

    /// Where the corners' vectors nearly cancel, float32 turns what is left by this much: only a surface that it may
    /// turn to the light gets any.
    void doubt_short_vectors(std::size_t i, const LightVectors &vectors) {
        const LightTerms terms = sampler_.terms_at(here_, i);
        double turned = 1 + excess(vectors.l_length);
        if (has_short_normal()) {
            // 8 units in the last place are enough for two terms of N's size; a lamp is seen from where the weights
            // say.
            const InterpolationTerms summed = sampler_.interpolation_terms();
            turned = std::max(summed.weights / 2, 1.0) / here_.normal_length + excess(vectors.l_length) +
                     (has_position(setup_.lights[i].light) ? summed.positions / vectors.d : 0);
        }
        const double turn = 2 * rounding * turned;
        const double highlight_turn = turn + 2 * rounding * excess(vectors.highlight_length);
        const double steepest = std::sqrt(std::max(terms.exponent, 1.0)) * 2;
        const Amounts amount = amounts(i, terms.vectors.a * terms.s, 1);
        const bool either_side = setup_.technique.direction == DirectionSign::unnegated_diffuse;
        if (either_side || terms.n_dot_l > -turn) {
            doubts_.rounding.body += amount.diffuse * std::min(turn, 1.0);
        }
        if (!asks_for_light() || terms.n_dot_l > -turn) {
            const double most = std::pow(std::min(terms.f + highlight_turn, 1.0), terms.exponent);
            doubts_.rounding.highlight += amount.highlight * std::min(steepest * highlight_turn, most);
        }
    }

    /// Does a highlight need a surface that faces the light?
    [[nodiscard]] bool asks_for_light() const {
        return setup_.technique.gate == Gate::light_facing || setup_.technique.gate == Gate::times_n_dot_l;
    }
    [[nodiscard]] bool adds_body() const { return terms_ != Terms::highlight; }
    [[nodiscard]] bool adds_highlight() const {
        return terms_ != Terms::body && reflection(setup_.technique.model).specular;
    }

    const Sampler &sampler_;
    const Setup &setup_;
    const Object &object_;
    Terms terms_;
    const SurfacePoint &here_;
    Doubts doubts_;
    std::optional<SurfacePoint> right_, below_;
    friend class Sampler;
};

bool direction_is_rounding(const Setup &setup, const LightSetup &light, const glm::dvec3 &position) {
    const double d = glm::length(light.position - position);
    return rounding * spread(setup, light, position, d) > far_from_a_branch;
}

LostDirection lost_direction(const Setup &setup, const LightSetup &light, const glm::dvec3 &position) {
    const double d = glm::length(light.position - position);
    const double share = std::min(2 * rounding * spread(setup, light, position, d), 1.0); // of the distance
    return {std::sqrt(1 - share * share), share};
}

SurfacePoint Sampler::surface_point(const glm::dvec3 &position, const glm::dvec3 &normal, Side side) const {
    const glm::dvec3 view = view_vector(setup_, position);
    return {.position = position,
            .raw_normal = normal,
            .normal_length = keeps_normal_lengths() ? 1 / std::max(glm::length(normal), 1e-300) : 1,
            .normal = facing(setup_, object_.two_sided, normal, view, side),
            .view = view};
}

LightVectors Sampler::vectors(const SurfacePoint &point, std::size_t light) const {
    return light_vectors(setup_, setup_.lights[light], point.position, point.normal, point.view);
}

LightTerms Sampler::terms_at(const SurfacePoint &point, std::size_t light) const {
    return light_terms(setup_, setup_.lights[light], vectors(point, light), point.normal, point.view,
                       object_.material.shininess);
}

Reflected Sampler::reflect(Terms terms, const SurfacePoint &point) const {
    glm::dvec3 ambient = setup_.ambient;
    glm::dvec3 diffuse(0);
    glm::dvec3 specular(0);
    for (std::size_t i = 0; i < setup_.lights.size(); ++i) {
        const LightTerms light = terms_at(point, i);
        ambient += light.ambient;
        diffuse += light.diffuse;
        specular += light.specular;
    }
    const Material &material = object_.material;
    Reflected reflected;
    if (terms != Terms::highlight) {
        reflected.body = material.ambient * ambient + material.diffuse * diffuse;
    }
    if (terms != Terms::body) {
        reflected.highlight = material.specular * specular;
    }
    return reflected;
}

std::vector<LightProbe> Sampler::probe_lights(const SurfacePoint &point) const {
    std::vector<LightProbe> lights;
    for (std::size_t i = 0; i < setup_.lights.size(); ++i) {
        lights.push_back({setup_.light_index[i], terms_at(point, i)});
    }
    return lights;
}

Doubts Sampler::doubts(Terms terms, const SurfacePoint &here) const { return Branches(*this, terms, here).doubts(); }

Reflected Sampler::doubt_of_direction(Terms terms, const SurfacePoint &here, std::size_t light,
                                      const Directions &to_light, const Directions &highlight) const {
    Branches branches(*this, terms, here);
    branches.doubt_direction(light, vectors(here, light).a, to_light, highlight);
    return branches.doubts_.rounding;
}

Doubts &operator+=(Doubts &sum, const Doubts &more) {
    for (const auto part : {&Doubts::jump, &Doubts::rounding}) {
        (sum.*part).body += (more.*part).body;
        (sum.*part).highlight += (more.*part).highlight;
    }
    return sum;
}

Doubts operator*(double weight, const Doubts &doubts) {
    return {{weight * doubts.jump.body, weight * doubts.jump.highlight},
            {weight * doubts.rounding.body, weight * doubts.rounding.highlight}};
}

PixelMasks Sampler::masks(const Doubts &doubts, const glm::dvec3 &base) const {
    const auto change = [&](const Reflected &part) {
        return largest(compose(object_.material, base, part) - object_.material.emission);
    };
    const double jump = change(doubts.jump);
    const double noise = change(doubts.rounding);
    return {jump > negligible_jump, noise > negligible_noise, jump + noise};
}

PixelMasks Sampler::border_masks(const Doubts &doubts, const Checker &checker, const Reflected &reflected) const {
    const auto &colors = checker.colors;
    PixelMasks result = masks(doubts, glm::max(colors[0], colors[1]));
    const glm::dvec3 tinted = object_.material.texture_modulates_specular ? reflected.highlight : glm::dvec3(0);
    const double jump = largest(glm::abs(colors[0] - colors[1]) * (reflected.body + tinted));
    result.jump = result.jump || jump > negligible_jump;
    result.doubt += jump;
    return result;
}

} // namespace sandbox::reference

#include "reference/branches.h"

#include "reference/raster.h"
#include "scene/light_kind.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <optional>

namespace sandbox::reference {

namespace {

constexpr double negligible = 1e-6;       ///< a smaller jump shows in no figure
constexpr double far_from_a_branch = 0.1; ///< N.L and cosines change less over edge_width
constexpr double steep_exponent = 0.5;    ///< f^n with a smaller n leaves 0 like a jump

double largest(const glm::dvec3 &v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// The two positions' lengths as multiples of the distance, which is computed as their difference.
double spread(const Setup &setup, const LightSetup &light, const glm::dvec3 &position, double d) {
    if (!has_position(light.light)) {
        return 0;
    }
    return (glm::length(position - setup.origin) + glm::length(light.position - setup.origin)) / std::max(d, 1e-300);
}

} // namespace

/// The branches at one point. Its neighbours are worked out only where a branch is close.
class Branches {
  public:
    Branches(const Sampler &sampler, Terms terms, const SurfacePoint &here)
        : sampler_(sampler), setup_(sampler.setup_), object_(sampler.object_), terms_(terms), here_(here) {}

    bool view_branch() {
        const auto n_dot_v = [](const SurfacePoint &p) { return glm::dot(p.raw_normal, p.view); };
        const bool gate = setup_.technique.gate == Gate::view_facing;
        const bool turned = object_.two_sided && setup_.technique.facing == Facing::view;
        if ((!turned && !gate) || !close(n_dot_v, 2 * rounding / here_.normal_length)) {
            return false;
        }
        return turned ? turning_matters() : light_sum_matters();
    }

    bool light_branches(std::size_t i) {
        const LightSetup &light = setup_.lights[i];
        const LightVectors vectors = sampler_.vectors(here_, i);
        if (direction_is_rounding(setup_, light, here_.position)) {
            return true;
        }
        const double lengths = spread(setup_, light, here_.position, vectors.d);
        const double noise = rounding * (1 / here_.normal_length + lengths);
        // A product of exact zeros has no rounding: a floor under a horizontal directional light is not in doubt.
        const double dot_noise =
            rounding * (glm::dot(glm::abs(here_.normal), glm::abs(vectors.l)) / here_.normal_length + lengths);
        const auto n_dot_l = [&](const SurfacePoint &p) { return glm::dot(p.normal, sampler_.vectors(p, i).l); };
        const auto beyond_cone = [&](const SurfacePoint &p) {
            return glm::dot(-sampler_.vectors(p, i).l, light.travel) - light.cos_outer;
        };
        const bool hard = light.cone && !(light.light.inner_cutoff_degrees < light.light.cutoff_degrees);
        if (hard && close(beyond_cone, noise) && amounts(i).cone > negligible) {
            return true;
        }
        const bool gated = adds_highlight() && setup_.technique.gate == Gate::light_facing;
        const bool where_lit = terms_ != Terms::highlight && setup_.technique.ambient == AmbientWhere::where_lit;
        if ((gated || where_lit) && close(n_dot_l, dot_noise)) {
            const Amounts amount = amounts(i);
            if ((gated && amount.highlight > negligible) || (where_lit && amount.ambient > negligible)) {
                return true;
            }
        }
        return steep_highlight(i, noise);
    }

  private:
    /// How much a branch would change the colour, at most.
    struct Amounts {
        double cone = 0, highlight = 0, ambient = 0;
    };

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

    Amounts amounts(std::size_t i) const {
        const LightTerms terms = sampler_.terms_at(here_, i);
        const Light &light = setup_.lights[i].light;
        const double reach = terms.vectors.a * terms.s_uncut;
        const glm::dvec3 ambient =
            object_.material.ambient * light.color * (light.ambient * (light.attenuate_ambient ? reach : 1));
        const glm::dvec3 diffuse =
            object_.material.diffuse * light.color * (light.diffuse * std::max(terms.n_dot_l, 0.0) * reach);
        const glm::dvec3 highlight = object_.material.specular * light.color * (light.specular * terms.f_power * reach);
        Amounts amount;
        amount.highlight = largest(highlight);
        amount.ambient = largest(ambient);
        amount.cone =
            (terms_ == Terms::highlight ? 0 : largest(diffuse) + (light.attenuate_ambient ? amount.ambient : 0)) +
            (terms_ == Terms::body ? 0 : amount.highlight);
        return amount;
    }

    /// For small n, f^n rises so steeply at f = 0 that a rounding of f is a jump of the highlight.
    bool steep_highlight(std::size_t i, double noise) {
        const double n = raised_exponent(setup_, object_.material.shininess);
        if (!adds_highlight() || n == 0 || n > steep_exponent) {
            return false;
        }
        const auto f = [&](const SurfacePoint &p) {
            const auto [a, b] = highlight_vectors(setup_.technique.model, sampler_.vectors(p, i), p.normal, p.view);
            return glm::dot(a, b);
        };
        if (!close(f, noise)) {
            return false;
        }
        const LightTerms terms = sampler_.terms_at(here_, i);
        const Light &light = setup_.lights[i].light;
        return terms.gate &&
               largest(object_.material.specular * light.color) * light.specular * terms.vectors.a * terms.s >
                   negligible;
    }

    bool turning_matters() const {
        SurfacePoint turned = here_;
        turned.normal = -here_.normal;
        const Reflected before = sampler_.reflect(terms_, here_);
        const Reflected after = sampler_.reflect(terms_, turned);
        return largest(before.body - after.body) + largest(before.highlight - after.highlight) > negligible;
    }

    bool light_sum_matters() const {
        for (std::size_t i = 0; adds_highlight() && i < setup_.lights.size(); ++i) {
            if (amounts(i).highlight > negligible) {
                return true;
            }
        }
        return false;
    }

    bool adds_highlight() const { return terms_ != Terms::body && reflection(setup_.technique.model).specular; }

    const Sampler &sampler_;
    const Setup &setup_;
    const Object &object_;
    Terms terms_;
    const SurfacePoint &here_;
    std::optional<SurfacePoint> right_, below_;
};

bool direction_is_rounding(const Setup &setup, const LightSetup &light, const glm::dvec3 &position) {
    const double d = glm::length(light.position - position);
    return rounding * spread(setup, light, position, d) > far_from_a_branch;
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

bool Sampler::may_jump(Terms terms, const SurfacePoint &here) const {
    Branches branches(*this, terms, here);
    bool jumps = branches.view_branch();
    for (std::size_t i = 0; !jumps && i < setup_.lights.size(); ++i) {
        jumps = branches.light_branches(i);
    }
    return jumps;
}

} // namespace sandbox::reference

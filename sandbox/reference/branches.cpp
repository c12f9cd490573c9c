#include "reference/branches.h"

#include "reference/raster.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <optional>

namespace sandbox::reference {

namespace {

constexpr double rounding = 8 * 0x1p-24;  ///< 8 units of float32 at 1
constexpr double negligible = 1e-6;       ///< a jump that no figure shows
constexpr double far_from_a_branch = 0.1; ///< N.L and cosines do not change as much over edge_width
constexpr double steep_exponent = 0.5;    ///< f^n with a smaller n leaves 0 like a jump

double largest(const glm::dvec3 &v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// The lengths whose difference gives the distance, as shares of it.
double spread(const LightSetup &light, const glm::dvec3 &position, double d) {
    if (light.light.type == LightType::directional) {
        return 0;
    }
    return (glm::length(position) + glm::length(light.position)) / std::max(d, 1e-300);
}

/// One place's branches, with its neighbours worked out only where something is close.
class Branches {
  public:
    Branches(const Setup &setup, const Material &material, Terms terms, const Place &here, const Sampler &sampler)
        : setup_(setup), material_(material), terms_(terms), here_(here), sampler_(sampler) {}

    bool view_branch(bool two_sided) {
        const auto n_dot_v = [](const Place &p) { return glm::dot(p.raw_normal, p.view); };
        const auto quantity = [&](const Place &p) { return n_dot_v(p); };
        const bool gate = setup_.technique.gate == Gate::view_facing;
        if ((!two_sided && !gate) || !close(quantity, 2 * rounding / here_.normal_length)) {
            return false;
        }
        return two_sided ? turning_matters() : light_sum_matters();
    }

    bool light_branches(std::size_t i) {
        const LightSetup &light = setup_.lights[i];
        const LightVectors vectors = sampler_.vectors(here_, i);
        if (direction_is_rounding(light, here_.position)) {
            return true;
        }
        const double lengths = spread(light, here_.position, vectors.d);
        const double noise = rounding * (1 / here_.normal_length + lengths);
        // A product of exact zeros has no rounding: a floor under a horizontal directional light is not in doubt.
        const double dot_noise =
            rounding * (glm::dot(glm::abs(here_.normal), glm::abs(vectors.l)) / here_.normal_length + lengths);
        const auto n_dot_l = [&](const Place &p) { return glm::dot(p.normal, sampler_.vectors(p, i).l); };
        const auto beyond_cone = [&](const Place &p) {
            return glm::dot(-sampler_.vectors(p, i).l, light.travel) - light.cos_outer;
        };
        const bool hard = light.cone && !(light.light.inner_cutoff_degrees < light.light.cutoff_degrees);
        if (hard && close(beyond_cone, noise) && amounts(i).cone > negligible) {
            return true;
        }
        const bool gated = terms_ != Terms::body && setup_.technique.gate == Gate::light_facing &&
                           setup_.technique.model != Model::lambert;
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
            right_ = sampler_.at(edge_width, 0);
            below_ = sampler_.at(0, edge_width);
        }
        return std::abs(q) < std::abs(quantity(*right_) - q) + std::abs(quantity(*below_) - q) + noise;
    }

    LightTerms terms_of(std::size_t i) const {
        return light_terms(setup_, setup_.lights[i], sampler_.vectors(here_, i), here_.normal, here_.view,
                           material_.shininess);
    }

    Amounts amounts(std::size_t i) const {
        const LightTerms terms = terms_of(i);
        const Light &light = setup_.lights[i].light;
        const double reach = terms.vectors.a * terms.s_uncut;
        const glm::dvec3 ambient =
            material_.ambient * light.color * (light.ambient * (light.attenuate_ambient ? reach : 1));
        const glm::dvec3 diffuse =
            material_.diffuse * light.color * (light.diffuse * std::max(terms.n_dot_l, 0.0) * reach);
        const glm::dvec3 highlight = material_.specular * light.color * (light.specular * terms.f_power * reach);
        Amounts amount;
        amount.highlight = largest(highlight);
        amount.ambient = largest(ambient);
        amount.cone =
            (terms_ == Terms::highlight ? 0 : largest(diffuse) + (light.attenuate_ambient ? amount.ambient : 0)) +
            (terms_ == Terms::body ? 0 : amount.highlight);
        return amount;
    }

    /// f^n near f = 0 for small n: a rounding of f there is a jump of the highlight.
    bool steep_highlight(std::size_t i, double noise) {
        const bool blinn = setup_.technique.model == Model::blinn_phong;
        const double n = material_.shininess * (blinn ? setup_.blinn_exponent_scale : 1);
        if (terms_ == Terms::body || setup_.technique.model == Model::lambert || n == 0 || n > steep_exponent) {
            return false;
        }
        const auto f = [&](const Place &p) {
            const LightVectors vectors = sampler_.vectors(p, i);
            return blinn ? glm::dot(p.normal, vectors.h) : glm::dot(vectors.r, p.view);
        };
        if (!close(f, noise)) {
            return false;
        }
        const LightTerms terms = terms_of(i);
        const Light &light = setup_.lights[i].light;
        return terms.gate &&
               largest(material_.specular * light.color) * light.specular * terms.vectors.a * terms.s > negligible;
    }

    bool turning_matters() const {
        Place turned = here_;
        turned.normal = -here_.normal;
        const Reflected one = reflect(setup_, material_, terms_, here_, sampler_);
        const Reflected other = reflect(setup_, material_, terms_, turned, sampler_);
        return largest(one.body - other.body) + largest(one.highlight - other.highlight) > negligible;
    }

    bool light_sum_matters() const {
        for (std::size_t i = 0; i < setup_.lights.size(); ++i) {
            if (terms_ != Terms::body && setup_.technique.model != Model::lambert &&
                amounts(i).highlight > negligible) {
                return true;
            }
        }
        return false;
    }

    const Setup &setup_;
    const Material &material_;
    Terms terms_;
    const Place &here_;
    const Sampler &sampler_;
    std::optional<Place> right_, below_;
};

} // namespace

bool direction_is_rounding(const LightSetup &light, const glm::dvec3 &position) {
    const double d = glm::length(light.position - position);
    return rounding * spread(light, position, d) > far_from_a_branch;
}

Point::Point(const Setup &setup, bool two_sided, const glm::dvec3 &position, const glm::dvec3 &normal) : setup_(setup) {
    place_.position = position;
    place_.raw_normal = normal;
    place_.view = view_vector(setup, position);
    place_.normal = facing(two_sided, normal, place_.view);
}

Place Point::at(double, double) const { return place_; }

LightVectors Point::vectors(const Place &place, std::size_t light) const {
    return light_vectors(setup_, setup_.lights[light], place.position, place.normal, place.view);
}

Reflected reflect(const Setup &setup, const Material &material, Terms terms, const Place &place,
                  const Sampler &sampler) {
    glm::dvec3 ambient = setup.ambient;
    glm::dvec3 diffuse(0);
    glm::dvec3 specular(0);
    for (std::size_t i = 0; i < setup.lights.size(); ++i) {
        const LightTerms light = light_terms(setup, setup.lights[i], sampler.vectors(place, i), place.normal,
                                             place.view, material.shininess);
        ambient += light.ambient;
        diffuse += light.diffuse;
        specular += light.specular;
    }
    Reflected reflected;
    if (terms != Terms::highlight) {
        reflected.body = material.ambient * ambient + material.diffuse * diffuse;
    }
    if (terms != Terms::body) {
        reflected.highlight = material.specular * specular;
    }
    return reflected;
}

bool may_jump(const Setup &setup, const Material &material, bool two_sided, Terms terms, const Place &here,
              const Sampler &sampler) {
    Branches branches(setup, material, terms, here, sampler);
    if (branches.view_branch(two_sided)) {
        return true;
    }
    for (std::size_t i = 0; i < setup.lights.size(); ++i) {
        if (branches.light_branches(i)) {
            return true;
        }
    }
    return false;
}

} // namespace sandbox::reference

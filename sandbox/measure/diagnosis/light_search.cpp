#include "measure/diagnosis/light_search.h"

#include "measure/diagnosis/linear_fit.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace sandbox {
namespace {

bool is_dark(const Scene &scene) {
    return scene.ambient == glm::dvec3(0) &&
           std::ranges::all_of(
               scene.lights,
               [](const Light &light) { return light.ambient == 0 && light.diffuse == 0 && light.specular == 0; }) &&
           std::ranges::all_of(scene.objects,
                               [](const Object &object) { return object.material.emission == glm::dvec3(0); });
}

} // namespace

LightSearch::LightSearch(std::shared_ptr<ScenePictures> plain, const std::vector<ObjectResources> &resources,
                         Search &search, std::function<void()> report)
    : plain_(std::move(plain)), resources_(resources), search_(search), report_(std::move(report)),
      parts_(linear_parts(plain_->scene())), pictures_{plain_} {}

std::optional<Explanation> LightSearch::explain(const Sought &sought) {
    const bool one = sought.changes.least <= 1;
    for (const Edit &edit : one ? scene_edits(plain_->scene()) : std::vector<Edit>{}) {
        if (auto explanation = explain_by(edit, candidates(edit.scene, sought), sought)) {
            return explanation;
        }
    }
    for (const LinearParts &parts : parts_) {
        if (auto explanation = explain_by_parts(parts, sought)) {
            return explanation;
        }
    }
    return one ? explain_by_exponent(sought) : std::nullopt;
}

std::shared_ptr<ScenePictures> LightSearch::pictures_of(const Scene &scene) {
    const auto found = std::ranges::find_if(pictures_, [&](const auto &known) { return known->scene() == scene; });
    return found != pictures_.end() ? *found
                                    : pictures_.emplace_back(std::make_shared<ScenePictures>(scene, search_.sampler()));
}

std::vector<Candidate> LightSearch::candidates(const Scene &scene, const Sought &sought) const {
    std::vector<Candidate> all = single_candidates(scene, resources_, sought.bases);
    std::erase_if(all, [&](const Candidate &candidate) { return candidate.faults != sought.faults; });
    return all;
}

std::optional<Explanation> LightSearch::explain_by(const Edit &edit, const std::vector<Candidate> &candidates,
                                                   const Sought &sought) {
    const auto pictures = pictures_of(edit.scene);
    std::vector<Convention> conventions = conventions_of(sought.reading);
    conventions.insert(conventions.end(), edit.conventions.begin(), edit.conventions.end());
    for (const Strictness strictness : sought.strictnesses) {
        if (auto found = search_.explain(*pictures, candidates, sought.reading, strictness, conventions)) {
            return Explanation{std::move(*found), sought.reading, pictures, std::move(conventions), strictness};
        }
    }
    return std::nullopt;
}

std::optional<Explanation> LightSearch::explain_by_parts(const LinearParts &parts, const Sought &sought) {
    const Search::Equations equations = search_.equations(sought.reading);
    for (const Candidate &candidate : candidates(plain_->scene(), sought)) {
        for (const Edit &edit : fitted(parts, candidate.technique, sought, equations)) {
            if (auto explanation = explain_by(edit, {candidate}, sought)) {
                return explanation;
            }
        }
    }
    return std::nullopt;
}

std::vector<Edit> LightSearch::fitted(const LinearParts &parts, const Technique &technique, const Sought &sought,
                                      const Search::Equations &equations) {
    const auto column = [&](const Scene &scene) {
        std::vector<double> values(equations.values.size());
        if (!is_dark(scene)) {
            report_();
            const Image &image = pictures_of(scene)->samples(technique);
            std::ranges::transform(equations.values, values.begin(), [&](std::size_t i) {
                return static_cast<double>(image.pixels[i / 3][static_cast<int>(i % 3)]);
            });
        }
        return values;
    };
    const std::vector<double> rest = column(parts.rest);
    std::vector<double> target = equations.light;
    for (std::size_t i = 0; i < target.size(); ++i) {
        target[i] -= rest[i];
    }
    std::vector<std::vector<double>> columns;
    std::ranges::transform(parts.parts, std::back_inserter(columns), column);
    const auto exact = fitted_factors(columns, target);
    std::vector<Edit> edits;
    for (const double digits : {1.0, 10.0, 100.0, 1000.0}) {
        if (!exact) {
            break;
        }
        std::vector<double> factors;
        std::ranges::transform(*exact, std::back_inserter(factors),
                               [&](double factor) { return plain_factor(factor, digits); });
        std::vector<double> light = rest;
        for (std::size_t part = 0; part < columns.size(); ++part) {
            for (std::size_t i = 0; i < light.size(); ++i) {
                light[i] += factors[part] * columns[part][i];
            }
        }
        Edit edit = with_factors(plain_->scene(), parts, factors);
        const bool is_new = edits.empty() || !(edits.back().scene == edit.scene);
        const std::size_t changes = edit.conventions.size();
        if (is_new && changes >= sought.changes.least && changes <= sought.changes.most &&
            search_.may_explain(equations, light, sought.reading)) {
            edits.push_back(std::move(edit));
        }
    }
    return edits;
}

double LightSearch::exponent_error(const Technique &technique, const Reading &reading, double octaves) {
    const Scene scene = with_exponents(plain_->scene(), std::exp2(octaves)).scene;
    return search_.sampled_difference(*pictures_of(scene), technique, reading).rms;
}

std::optional<double> LightSearch::exponent_factor(const Technique &technique, const Reading &reading) {
    const auto error = [&](double octaves) { return exponent_error(technique, reading, octaves); };
    constexpr double rung = 0.5, most = 3;
    double best = 0;
    double least = error(0);
    for (double octaves = -most; octaves <= most; octaves += rung) {
        if (const double here = error(octaves); here < least) {
            least = here;
            best = octaves;
        }
    }
    constexpr double hopeless = 6; // levels: other exponents alone do not make that picture
    if (best == 0 || least > hopeless) {
        return std::nullopt;
    }
    double low = best - rung;
    double high = best + rung;
    constexpr double golden = 0.6180339887498949;
    for (int i = 0; i < 14; ++i) {
        const double left = high - golden * (high - low);
        const double right = low + golden * (high - low);
        const bool lower = error(left) < error(right);
        (lower ? high : low) = lower ? right : left;
    }
    return std::exp2((low + high) / 2);
}

std::optional<Explanation> LightSearch::explain_by_exponent(const Sought &sought) {
    std::vector<std::pair<double, Candidate>> nearest;
    for (const Candidate &candidate : candidates(plain_->scene(), sought)) {
        if (reflection(candidate.technique.model).specular) {
            const auto error = [&](double octaves) {
                return exponent_error(candidate.technique, sought.reading, octaves);
            };
            nearest.emplace_back(std::min({error(-1), error(0), error(1)}), candidate);
        }
    }
    constexpr std::size_t most_tried = 4; // each takes some tens of pictures
    std::ranges::stable_sort(nearest, {}, [](const auto &ranked) { return ranked.first; });
    nearest.resize(std::min(nearest.size(), most_tried));
    for (const auto &[rms, candidate] : nearest) {
        const auto factor = exponent_factor(candidate.technique, sought.reading);
        for (const double digits : {1.0, 4.0, 100.0, 1000.0}) { // people choose plain numbers
            const double plain = factor ? std::round(*factor * digits) / digits : 1;
            if (plain <= 0 || plain == 1) {
                continue;
            }
            if (auto explanation = explain_by(with_exponents(plain_->scene(), plain), {candidate}, sought)) {
                return explanation;
            }
        }
    }
    return std::nullopt;
}

} // namespace sandbox

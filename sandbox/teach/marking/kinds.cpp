#include "teach/marking/kinds.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace sandbox {
namespace {

double largest(const glm::vec3 &v) { return static_cast<double>(std::max({v.x, v.y, v.z})); }
double farthest(const glm::vec3 &v) { return largest(glm::abs(v)); }

/// The channels' factors that bring the truth nearest to the answer, by least squares.
glm::dvec3 factors(std::span<const glm::vec3> answer, std::span<const glm::vec3> truth) {
    glm::dvec3 both(0), own(0);
    for (std::size_t i = 0; i < answer.size(); ++i) {
        both += glm::dvec3(answer[i]) * glm::dvec3(truth[i]);
        own += glm::dvec3(truth[i]) * glm::dvec3(truth[i]);
    }
    glm::dvec3 found(1);
    for (int c = 0; c < 3; ++c) {
        found[c] = own[c] > 0 ? both[c] / own[c] : 1;
    }
    return found;
}

/// Of all pixels and channels.
struct Facts {
    double least = 0, most = 0, most_true = 0; ///< of a channel
    double spread = 0;                         ///< of the answer: its most less its least
    double least_shown = 0;
    std::size_t lit = 0, lit_true = 0; ///< pixels that show it by more than a tenth of its brightest
    std::size_t both = 0;
    std::size_t wrong = 0, wrong_unlit = 0, wrong_missing = 0;
    double after_factors = 0; ///< the largest error once the truth is multiplied
};

Facts facts_of(std::span<const glm::vec3> answer, std::span<const glm::vec3> truth, double tolerance,
               const glm::dvec3 &factor) {
    Facts facts;
    facts.least = facts.least_shown = 1e300;
    for (std::size_t i = 0; i < answer.size(); ++i) {
        const double high = largest(answer[i]);
        facts.most = std::max(facts.most, high);
        facts.least_shown = std::min(facts.least_shown, high);
        facts.least = std::min(facts.least, -largest(-answer[i]));
        facts.most_true = std::max(facts.most_true, largest(truth[i]));
    }
    for (std::size_t i = 0; i < answer.size(); ++i) {
        const bool lit = largest(answer[i]) > std::max(0.1 * facts.most, tolerance);
        const bool lit_true = largest(truth[i]) > std::max(0.1 * facts.most_true, tolerance);
        facts.lit += lit ? 1 : 0;
        facts.lit_true += lit_true ? 1 : 0;
        facts.both += lit && lit_true ? 1 : 0;
        const glm::vec3 by = answer[i] - truth[i];
        if (farthest(by) > tolerance) {
            ++facts.wrong;
            facts.wrong_unlit += farthest(truth[i]) <= tolerance ? 1 : 0;
            facts.wrong_missing += farthest(answer[i]) <= tolerance ? 1 : 0;
        }
        facts.after_factors =
            std::max(facts.after_factors, farthest(glm::vec3(glm::dvec3(answer[i]) - factor * glm::dvec3(truth[i]))));
    }
    facts.spread = facts.most - facts.least_shown;
    return facts;
}

} // namespace

ErrorKind kind_of(std::span<const glm::vec3> answer, std::span<const glm::vec3> truth, double tolerance) {
    for (const glm::vec3 &color : answer) {
        if (!std::isfinite(color.x) || !std::isfinite(color.y) || !std::isfinite(color.z)) {
            return ErrorKind::not_finite;
        }
    }
    if (answer.empty()) {
        return ErrorKind::shape;
    }
    const glm::dvec3 factor = factors(answer, truth);
    const Facts facts = facts_of(answer, truth, tolerance, factor);
    constexpr double most_of = 0.9, clearly = 1.3;
    const double fits = std::max(2 * tolerance, 0.02 * facts.most);
    if (facts.most <= tolerance && facts.least >= -tolerance) {
        return ErrorKind::missing;
    }
    if (facts.least < -tolerance) {
        return ErrorKind::negative;
    }
    if (facts.after_factors <= fits) {
        const double low = std::min({factor.x, factor.y, factor.z}), high = std::max({factor.x, factor.y, factor.z});
        return high - low > 0.05 * high ? ErrorKind::color : high > 1 ? ErrorKind::too_bright : ErrorKind::too_dark;
    }
    const auto lit = static_cast<double>(facts.lit), lit_true = static_cast<double>(facts.lit_true);
    if (static_cast<double>(facts.wrong_unlit) > most_of * static_cast<double>(facts.wrong)) {
        return ErrorKind::unlit_too;
    }
    if (facts.spread <= fits) {
        return ErrorKind::everywhere;
    }
    if (static_cast<double>(facts.both) < 0.5 * std::min(lit, lit_true)) {
        return ErrorKind::elsewhere;
    }
    if (lit > clearly * lit_true) {
        return ErrorKind::too_wide;
    }
    return clearly * lit < lit_true ? ErrorKind::too_narrow : ErrorKind::shape;
}

} // namespace sandbox

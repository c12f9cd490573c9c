#pragma once

#include "scene/resources.h"
#include "shading/technique.h"

#include <optional>
#include <vector>

/// What a picture of a scene may be: the techniques that draw it differently. The one place that lists them.
namespace sandbox {

/// Techniques that draw the scene with the same programs, fed the same numbers.
struct Candidate {
    Technique technique;         ///< the first of `same`
    std::vector<Technique> same; ///< those without a setting that has no effect; never empty
    std::size_t faults = 0;      ///< settings of `technique` beside its base's
};

/// Frequency and model alone, as techniques to begin with: every pair, the default one first; of `given` its own pair
/// with its variants, its faults dropped; where its model is `own`, its frequency with every model.
std::vector<Technique> base_techniques(const std::optional<Technique> &given);

/// Each base without a fault, then with every single one that it allows and that changes a picture of the scene:
/// faults, and the variants that change the equation (normalisation; power and program only change how float32 gets
/// there).
std::vector<Candidate> single_candidates(const Scene &scene, const std::vector<ObjectResources> &resources,
                                         const std::vector<Technique> &bases);
/// Likewise with two of them.
std::vector<Candidate> pair_candidates(const Scene &scene, const std::vector<ObjectResources> &resources,
                                       const std::vector<Technique> &bases);

} // namespace sandbox

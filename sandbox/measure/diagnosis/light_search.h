#pragma once

#include "measure/diagnosis/conventions.h"
#include "measure/diagnosis/search.h"
#include "scene/resources.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace sandbox {

/// How many things may be otherwise about the light.
struct Changes {
    std::size_t least, most;
};
constexpr Changes one_change{1, 1}, several_changes{2, 1000};

struct Explanation {
    Found found;
    Reading reading;
    std::shared_ptr<ScenePictures> pictures; ///< of the scene under its conventions
    std::vector<Convention> conventions;
    Strictness strictness = Strictness::everywhere;
};

/// Explains a picture by other light than the scene's: something is left out, light or exponents have a factor. What is
/// drawn is kept, as the same pictures serve every way to write numbers.
class LightSearch {
  public:
    /// `plain` are the scene's own pictures. All must outlive this.
    LightSearch(std::shared_ptr<ScenePictures> plain, const std::vector<ObjectResources> &resources, Search &search,
                std::function<void()> report);

    struct Sought {
        std::vector<Technique> bases;
        std::size_t faults; ///< of the techniques, exactly: 0 or 1
        Changes changes;
        Reading reading;
        std::vector<Strictness> strictnesses;
    };
    std::optional<Explanation> explain(const Sought &sought);

  private:
    /// The pictures of a scene, the same for the same scene.
    std::shared_ptr<ScenePictures> pictures_of(const Scene &scene);
    [[nodiscard]] std::vector<Candidate> candidates(const Scene &scene, const Sought &sought) const;
    /// One edit of the scene, under each candidate.
    std::optional<Explanation> explain_by(const Edit &edit, const std::vector<Candidate> &candidates,
                                          const Sought &sought);
    std::optional<Explanation> explain_by_parts(const LinearParts &parts, const Sought &sought);
    std::optional<Explanation> explain_by_exponent(const Sought &sought);
    /// The parts' factors by least squares over the samples, rounded to whole numbers, to tenths, ... as people choose
    /// them; those roundings that may draw the picture, the coarsest first.
    std::vector<Edit> fitted(const LinearParts &parts, const Technique &technique, const Sought &sought,
                             const Search::Equations &equations);
    /// By how much it is off with exponents so many octaves higher: levels.
    double exponent_error(const Technique &technique, const Reading &reading, double octaves);
    /// The factor on the exponents that comes nearest, searched: on a coarse ladder, then by golden section around its
    /// best rung. Nothing where no factor comes near.
    std::optional<double> exponent_factor(const Technique &technique, const Reading &reading);

    std::shared_ptr<ScenePictures> plain_;
    const std::vector<ObjectResources> &resources_;
    Search &search_;
    std::function<void()> report_;
    std::vector<LinearParts> parts_;
    std::vector<std::shared_ptr<ScenePictures>> pictures_;
};

} // namespace sandbox

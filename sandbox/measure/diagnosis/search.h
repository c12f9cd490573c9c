#pragma once

#include "measure/diagnosis/candidates.h"
#include "measure/diagnosis/conventions.h"
#include "measure/diagnosis/levels.h"
#include "measure/diagnosis/pictures.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

/// Finds which candidates draw a picture: few of its pixels rule most of them out, the whole picture decides.
namespace sandbox {

/// 1 where a pixel counts.
using PixelMask = std::vector<std::uint8_t>;

/// Is every pixel that shows an object compared, or only those that `compare` compares? The first is owed to pictures
/// of this program's own making, down to its rounding at edges; the second to other programs, which may also raise
/// stiff highlights by pow().
enum class Strictness { everywhere, masked };

struct Found {
    Technique technique;
    std::vector<Technique> same; ///< other techniques of the same picture
    std::size_t faults = 0;
    Difference residual;
    PixelMask compared;
};

/// The candidate that is nearest to the picture by its samples, explaining it or not.
struct Nearest {
    Technique technique;
    Reading reading;
    Scene scene;
    std::vector<Convention> conventions;
    double rms = 0;
};

class Search {
  public:
    /// All must outlive this. `report` is called before each picture is drawn and may throw Cancelled.
    Search(const Scene &scene, const Observed &observed, const DiagnosisDraw &draw, std::function<void()> report);

    [[nodiscard]] Sampler &sampler() { return sampler_; }
    /// 1 where an object is shown.
    [[nodiscard]] const PixelMask &shown() const { return shown_; }
    [[nodiscard]] const std::optional<Nearest> &nearest() const { return nearest_; }
    [[nodiscard]] std::size_t drawn() const { return drawn_; }

    /// By its samples alone: the difference of a technique's picture from the observed one.
    Difference sampled_difference(ScenePictures &pictures, const Technique &technique, const Reading &reading);
    /// The candidate of fewest faults, among those the nearest, that explains the picture to within tolerated_levels.
    std::optional<Found> explain(ScenePictures &pictures, const std::vector<Candidate> &candidates,
                                 const Reading &reading, Strictness strictness,
                                 const std::vector<Convention> &conventions = {});
    /// The other candidates whose pictures differ from the found one's by at most one level wherever it is compared.
    std::vector<Technique> ties(ScenePictures &pictures, const std::vector<Candidate> &candidates, const Found &found,
                                const Reading &reading);
    /// Where the samples of the observed picture are light that is neither cut nor infinite: numbers to solve with.
    struct Equations {
        std::vector<std::size_t> values; ///< indices into the samples' channels
        std::vector<double> light;       ///< linear, as the picture has it there
    };
    [[nodiscard]] Equations equations(const Reading &reading) const;
    /// Is `light`, at those numbers, so near that masks may excuse the rest?
    [[nodiscard]] bool may_explain(const Equations &equations, const std::vector<double> &light,
                                   const Reading &reading);

  private:
    [[nodiscard]] const Levels &observed(const Reading &reading, bool whole);
    [[nodiscard]] PixelMask masked_pixels(const ScenePictures &pictures, const Technique &technique) const;
    /// Are samples too far apart that masks cannot excuse? Spares the whole picture in double.
    [[nodiscard]] bool hopeless_beside_masks(const ScenePictures &pictures, const Technique &technique,
                                             const Reading &reading);
    [[nodiscard]] std::size_t allowed(Strictness strictness) const;
    /// By how many levels each pixel may be off where pow() raises a highlight in float32; empty: none is worth it.
    [[nodiscard]] std::vector<double> power_rounding(const Scene &scene, const Technique &technique);
    /// Does what is left lie within that rounding?
    [[nodiscard]] bool within_rounding(const ScenePictures &pictures, const Technique &technique, const Levels &seen,
                                       const Levels &drawn, const PixelMask &compared);

    const Scene &scene_;
    const Observed &observed_;
    const DiagnosisDraw &draw_;
    std::function<void()> report_;
    Sampler sampler_;
    const PointSamples &samples_;
    std::vector<std::uint32_t> ids_;
    PixelMask shown_, sampled_shown_, sampled_inside_; ///< inside: no other object, nor the background, next to it
    std::size_t sampled_count_ = 0;
    struct ObservedLevels {
        Reading reading;
        Levels whole, samples;
    };
    std::vector<ObservedLevels> levels_;
    std::optional<Nearest> nearest_;
    std::size_t drawn_ = 0;
};

} // namespace sandbox

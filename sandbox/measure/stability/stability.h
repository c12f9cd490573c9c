#pragma once

#include "image/image.h"
#include "measure/metrics/metrics.h"
#include "measure/stability/cases.h"
#include "scene/resources.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The stiff and extreme cases: scenes on which a textbook's float32 formulas break, drawn and judged against the
/// double reference. Knows no OpenGL.
namespace sandbox {

/// One picture against the truth.
struct StabilityRow {
    Technique technique;
    Metrics metrics;
    double error = 0; ///< the largest difference, in the case's unit; infinite if a pixel is not finite
    bool passed = false;
};

struct StabilityResult {
    StabilityCase of;
    std::vector<StabilityRow> rows; ///< as of.techniques
    StabilityRow textbook;
    /// Run time of of.techniques[0] over that of the same program without guards; 1 where it has none anyhow.
    std::optional<double> cost;
    double exposure = 1; ///< of the pictures: see stability_exposure()
    ByteImage textbook_image, robust_image, reference_image;

    [[nodiscard]] bool passed() const;
    /// The row with the largest error.
    [[nodiscard]] const StabilityRow &worst() const;
};

/// How a case is drawn: the renderer, or a fake in a test.
struct StabilityDraw {
    std::function<std::vector<ObjectResources>(const Scene &)> load;
    /// With object ids, of the size that is asked for.
    std::function<Frame(const Scene &, const Technique &, Size)> picture;
    /// Draws and waits until done; milliseconds of the wall clock. Empty: no costs.
    std::function<double(const Scene &, const Technique &)> timed;
    /// The same without the guards and stable powers that the scene needs: the textbook's program, timed only.
    std::function<double(const Scene &, const Technique &)> timed_unguarded;
};

constexpr Size stability_size{129, 129}; ///< odd: one pixel looks straight ahead
/// Costs are taken on a picture large enough for the fragments to count.
constexpr Size stability_timed_size{256, 256};
/// Fewer compared pixels than this share of the picture, or more pixels than this that show another object, and a case
/// fails: what is not there cannot be judged.
constexpr double least_compared_share = 0.01;
constexpr double most_silhouette_share = 0.02;

/// Judges `drawn` against `truth` as a case's bound says.
StabilityRow judge_stability(const Frame &drawn, const ReferenceFrame &truth, const Technique &technique, double bound,
                             ErrorUnit unit);

/// What the pictures of a case are multiplied by: 1, or what makes the brightest value of `truth` white where the case
/// counts in brightest values.
double stability_exposure(const StabilityCase &one, const ReferenceFrame &truth);

StabilityResult run_stability_case(const StabilityCase &one, const StabilityDraw &draw, Size size = stability_size);

/// A textbook's equation in float32, per pixel, on the CPU: world-space positions, inverse() of the model matrix,
/// normalize without a guard, 1 / (kc + kl d + kq d^2), exp2(n log2 f), a cone by a clamped quotient. `technique` gives
/// the model alone. What it draws, it draws where the reference does.
Frame textbook_picture(const Scene &scene, const std::vector<ObjectResources> &resources, const Technique &technique,
                       Size size);

/// stability.html, .json, .csv. `renderer` and `version` are shown.
struct StabilityRun {
    std::vector<StabilityResult> results;
    std::string renderer, version;
};
std::string stability_html(const StabilityRun &run);
std::string stability_json(const StabilityRun &run);
std::string stability_csv(const StabilityRun &run);
/// What the page and the window say of a bound and a cost: "1.00e-06 of the brightest value", "1.04 times ...".
std::string bound_words(const StabilityCase &of);
std::string cost_words(double cost);
/// The table that the command prints.
std::string stability_table(const StabilityRun &run);

} // namespace sandbox

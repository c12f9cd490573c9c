#pragma once

#include "image/image.h"
#include "measure/metrics/metrics.h"
#include "measure/stability/cases.h"
#include "scene/resources.h"

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

/// Draws the stiff and extreme cases, on which a textbook's float32 formulas break, and judges them against the double
/// reference. Knows no OpenGL.
namespace sandbox {

/// One picture against the truth.
struct StabilityRow {
    Technique technique;
    Metrics metrics;
    double error = 0; ///< the largest difference, in the case's unit; infinite if a pixel is not finite
    bool passed = false;
    /// Why this device cannot draw it, which is no failure; empty: it was drawn.
    std::string refused{};
};

struct StabilityResult {
    StabilityCase definition;
    std::vector<StabilityRow> rows; ///< in the order of definition.techniques
    StabilityRow textbook;
    bool guarded = true; ///< false: the scene needs no guard, so the program is the textbook's
    /// Run time of the first technique over that of the same program without guards; nothing if it was not timed.
    std::optional<double> cost;
    double exposure = 1; ///< of the pictures: see stability_exposure()
    ByteImage textbook_image, robust_image, reference_image;

    /// Every row that could be drawn.
    [[nodiscard]] bool passed() const;
    /// Does the textbook's form show damage on the renderer at hand? If not, the case says where it was seen.
    [[nodiscard]] bool textbook_breaks() const { return !textbook.passed; }
    /// The row with the largest error, of those that could be drawn.
    [[nodiscard]] const StabilityRow &worst() const;
    /// The cost; 1 where there are no guards to pay for.
    [[nodiscard]] std::optional<double> cost_ratio() const { return guarded ? cost : 1; }
};

/// How a case is drawn: by the renderer, or by a fake in a test.
struct StabilityDraw {
    std::function<std::vector<ObjectResources>(const Scene &)> load;
    /// With object ids, of the size that is asked for. Throws DeviceLimitError where the device cannot.
    std::function<Frame(const Scene &, const Technique &, Size)> picture;
    /// Draws and waits until done; milliseconds of the wall clock. Empty: no costs.
    std::function<double(const Scene &, const Technique &)> timed;
    /// The same without the guards and stable powers that the scene needs: the textbook's program, timed only.
    std::function<double(const Scene &, const Technique &)> timed_unguarded;
};

constexpr Size stability_size{129, 129}; ///< odd: one pixel looks straight ahead
/// Costs are taken on a picture large enough for the fragments to count.
constexpr Size stability_timed_size{256, 256};
/// A case fails if a smaller share than the first of the pixels that show an object is compared (Metrics), or if more
/// than the second of all pixels show another object: what is not there cannot be judged.
constexpr double least_compared_share = trusted_share;
constexpr double most_silhouette_share = 0.02;

/// Judges `drawn` against `truth` by a bound.
StabilityRow judge_stability(const Frame &drawn, const ReferenceFrame &truth, const Technique &technique, double bound,
                             ErrorUnit unit);

/// What the pictures of a case are multiplied by: 1, or what makes the brightest value of `truth` white where the case
/// counts in brightest values.
double stability_exposure(const StabilityCase &drawn, const ReferenceFrame &truth);

StabilityResult run_stability_case(const StabilityCase &definition, const StabilityDraw &draw,
                                   Size size = stability_size);

/// Draws with render/'s Renderer, which this room cannot name. Costs are taken on `target`, which should have
/// stability_timed_size, by the wall clock. Both must outlive what is returned.
template <typename Renderer, typename Target> StabilityDraw cases_drawn_by(Renderer &renderer, Target &target) {
    const auto timed = [&target](const auto &draw) {
        const auto start = std::chrono::steady_clock::now();
        draw();
        target.finish();
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    };
    return {[&](const Scene &s) { return renderer.resources().load(s); },
            [&](const Scene &s, const Technique &t, Size size) { return renderer.render(s, t, size, true); },
            [&, timed](const Scene &s, const Technique &t) { return timed([&] { renderer.draw(s, t, target); }); },
            [&, timed](const Scene &s, const Technique &t) {
                return timed([&] { renderer.draw_unguarded(s, t, target); });
            }};
}

} // namespace sandbox

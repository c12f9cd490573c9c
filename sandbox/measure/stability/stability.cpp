#include "measure/stability/stability.h"

#include "image/device_limit.h"
#include "image/thread.h"
#include "measure/stability/textbook.h"
#include "reference/reference.h"
#include "shading/prepared_object.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/packing.hpp>
#include <tuple>

namespace sandbox {
namespace {

constexpr int cost_turns = 15;

/// A picture darker than this counts as black: float32 ends at 1e-38, and the factors of a colour may be smaller than
/// the colour.
constexpr double darkest = 1e-30;

double brightest(const ReferenceFrame &truth) {
    double largest = 0;
    for (std::size_t i = 0; i < truth.color.size(); ++i) {
        if (truth.object_ids[i] != 0 && truth.edge[i] == 0 && truth.jump[i] == 0 && truth.rounding[i] == 0) {
            const glm::dvec3 &c = truth.color[i];
            largest = std::max({largest, c.x, c.y, c.z});
        }
    }
    return largest;
}

bool needs_guards(const StabilityCase &drawn, const std::vector<ObjectResources> &resources) {
    const auto features = object_features(drawn.scene, drawn.techniques.front(), resources);
    return !std::ranges::all_of(features, [](const Features &f) { return without_guards(f) == f; });
}

/// The median of the ratios; the two programs take turns, so that a drift of the machine hits both alike.
double cost_of(const StabilityCase &timed, const StabilityDraw &draw) {
    std::vector<double> ratios;
    for (int turn = -2; turn < cost_turns; ++turn) {
        let_others_run();
        const double robust = draw.timed(timed.scene, timed.techniques.front());
        const double textbook = draw.timed_unguarded(timed.scene, timed.techniques.front());
        if (turn >= 0) {
            ratios.push_back(robust / textbook);
        }
    }
    std::nth_element(ratios.begin(), ratios.begin() + cost_turns / 2, ratios.end());
    return ratios[cost_turns / 2];
}

/// As a target of half floats keeps them.
void round_to_half(Image &image) {
    for (glm::vec4 &pixel : image.pixels) {
        pixel = glm::unpackHalf4x16(glm::packHalf4x16(pixel));
    }
}

} // namespace

bool StabilityResult::passed() const {
    return !rows.empty() &&
           std::ranges::all_of(rows, [](const StabilityRow &row) { return row.passed || !row.refused.empty(); });
}

const StabilityRow &StabilityResult::worst() const {
    return *std::ranges::max_element(rows, [](const StabilityRow &a, const StabilityRow &b) {
        const auto badness = [](const StabilityRow &row) {
            return std::tuple(row.refused.empty(), !row.passed, row.error);
        };
        return badness(a) < badness(b);
    });
}

StabilityRow judge_stability(const Frame &drawn, const ReferenceFrame &truth, const Technique &technique, double bound,
                             ErrorUnit unit) {
    StabilityRow row;
    row.technique = technique;
    row.metrics = compare(drawn, truth, Flip::without);
    const double scale = unit == ErrorUnit::brightest_value ? std::max(brightest(truth), darkest) : 1;
    row.error = row.metrics.norms.max_abs / scale;
    const auto pixels = static_cast<double>(truth.color.size());
    row.passed = row.metrics.nonfinite_pixels == 0 && row.error <= bound &&
                 row.metrics.compared_share >= least_compared_share &&
                 static_cast<double>(row.metrics.silhouette_pixels) <= most_silhouette_share * pixels;
    return row;
}

double stability_exposure(const StabilityCase &drawn, const ReferenceFrame &truth) {
    const double white = drawn.unit == ErrorUnit::brightest_value ? brightest(truth) : 1;
    return white > 0 ? 1 / white : 1;
}

StabilityResult run_stability_case(const StabilityCase &definition, const StabilityDraw &draw, Size size) {
    StabilityResult result;
    result.definition = definition;
    const auto resources = draw.load(definition.scene);
    for (const Technique &technique : definition.techniques) {
        const ReferenceFrame truth = render_reference(definition.scene, resources, technique, size);
        let_others_run();
        Frame frame{Image(size), {}};
        try {
            frame = draw.picture(definition.scene, technique, size);
            result.rows.push_back(judge_stability(frame, truth, technique, definition.bound, definition.unit));
        } catch (const DeviceLimitError &refusal) {
            result.rows.push_back({technique, {}, 0, false, refusal.what()});
        }
        if (result.rows.size() > 1) {
            continue;
        }
        let_others_run();
        const Technique textbook = definition.textbook.value_or(technique);
        Frame naive = definition.textbook ? draw.picture(definition.scene, textbook, size)
                                          : textbook_picture(definition.scene, resources, technique, size);
        if (definition.textbook_target == TextbookTarget::half) {
            round_to_half(naive.color);
        }
        result.textbook = judge_stability(naive, truth, textbook, definition.bound, definition.unit);
        result.exposure = stability_exposure(definition, truth);
        result.textbook_image = to_display(naive.color, Display::linear, result.exposure);
        result.robust_image = to_display(frame.color, Display::linear, result.exposure);
        // Rounded to float after the exposure: a truth beyond float's range must still be shown.
        ReferenceFrame shown = truth;
        for (glm::dvec3 &color : shown.color) {
            color *= result.exposure;
        }
        result.reference_image = to_display(to_frame(shown).color);
    }
    result.guarded = needs_guards(definition, resources);
    if (result.guarded && draw.timed && draw.timed_unguarded) {
        result.cost = cost_of(definition, draw);
    }
    return result;
}

} // namespace sandbox

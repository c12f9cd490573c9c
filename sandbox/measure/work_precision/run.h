#pragma once

#include "image/image.h"
#include "measure/metrics/metrics.h"
#include "measure/work_precision/plan.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

/// Error against run time: every planned row drawn, judged against the truth and timed in turns. Knows no OpenGL.
namespace sandbox {

/// Milliseconds of one frame: clear, draw, finish. The quartiles are those of the samples, interpolated linearly.
struct RunTime {
    std::vector<double> samples; ///< in the order of the rounds; warm-ups are not among them
    double min = 0, lower_quartile = 0, median = 0, upper_quartile = 0;
};
/// `samples` must not be empty.
RunTime run_time(std::vector<double> samples);

struct RowErrors {
    Metrics total; ///< the float32 picture against the truth
    ErrorSplit split;
};

struct MeasuredRow {
    PlannedRow plan;
    std::string refused; ///< why it could not be drawn; empty if it was
    std::optional<RowErrors> errors;
    std::optional<RunTime> time;

    [[nodiscard]] bool complete() const { return refused.empty() && errors && time; }
    [[nodiscard]] bool finite() const { return errors && errors->total.nonfinite_pixels == 0; }
};

/// Where the harness's own time went, in seconds; `other` is all that is neither drawing, reference nor metrics.
struct Accounting {
    double drawing = 0, reference = 0, metrics = 0, other = 0;
};

struct WorkPrecision {
    Scene scene;
    PlanOptions options;
    std::vector<PlannedMesh> meshes;
    std::vector<MeasuredRow> rows;
    std::vector<OmittedRow> omitted;
    /// Empty: the truth is the analytic surface; else why it is the finest mesh's.
    std::string no_analytic_surface;
    bool finished = false; ///< false: stopped half-way; what was measured is here
    Accounting seconds;
};

/// How a row is drawn: the renderer, or a fake in a test.
struct DrawRows {
    /// The meshes and textures of a scene.
    std::function<std::vector<ObjectResources>(const Scene &)> load;
    /// The picture with object ids. Throws InputError where the technique is refused for the scene.
    std::function<Frame(const Scene &, const Technique &)> picture;
    /// Draws without object ids and without reading back, waits until done; milliseconds.
    std::function<double(const Scene &, const Technique &)> timed;
};

/// Errors first, once a row; then rounds in which every row is drawn once: `options.warm_ups` rounds are dropped,
/// `options.repeats` kept. If `progress` returns false the work stops and the result is marked unfinished.
WorkPrecision measure_work_precision(const Scene &scene, const PlanOptions &options, const DrawRows &draw,
                                     const Progress &progress = {});

/// The truth that a row of this model is judged against: per-pixel, every fault off, on the analytic surface or, where
/// `analytic` is false, on the last of `meshes`, the finest.
ReferenceFrame report_truth(Model model, bool analytic, const std::vector<PlannedMesh> &meshes, Size size,
                            const std::function<std::vector<ObjectResources>(const Scene &)> &load,
                            const Progress &progress = {});

} // namespace sandbox

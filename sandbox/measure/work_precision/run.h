#pragma once

#include "image/image.h"
#include "measure/metrics/certificate_figures.h"
#include "measure/metrics/metrics.h"
#include "measure/work_precision/plan.h"
#include "measure/work_precision/precision.h"

#include <cstddef>
#include <functional>
#include <memory>
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
inline constexpr Quantity<RunTime> run_time_quantities[]{
    {"median", "median, ms", "ms", "median time of a frame", &RunTime::median},
    {"min", "least", "ms", "shortest time of a frame", &RunTime::min},
    {"lower_quartile", "", "ms", "a quarter of the frames took less", &RunTime::lower_quartile},
    {"upper_quartile", "", "ms", "a quarter of the frames took longer", &RunTime::upper_quartile},
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
    std::optional<CertificateFigures> certificate{}; ///< of the frequency auto

    [[nodiscard]] bool complete() const { return refused.empty() && errors && time; }
    [[nodiscard]] bool finite() const { return errors && errors->total.nonfinite_pixels == 0; }
    /// Why its errors say too little to be recommended by, shown in plots or ranked; empty where they count.
    [[nodiscard]] std::string mark() const { return errors ? why_untrusted(errors->total) : std::string(); }
    /// Finite errors over enough of the picture.
    [[nodiscard]] bool trusted() const { return finite() && mark().empty(); }
};

/// Where the time of the whole measurement went, in seconds.
struct Accounting {
    double drawing = 0, reference = 0, metrics = 0, other = 0;
};
inline constexpr Quantity<Accounting> accounting_quantities[]{
    {"drawing", "drawing", "s", "drawing", &Accounting::drawing},
    {"reference", "truth", "s", "the truth in double precision", &Accounting::reference},
    {"metrics", "comparing", "s", "comparing pictures", &Accounting::metrics},
    {"other", "all else", "s", "all else", &Accounting::other},
};

struct WorkPrecision {
    Scene scene;
    PlanOptions options;
    std::vector<PlannedMesh> meshes;
    std::vector<MeasuredRow> rows;
    std::vector<OmittedRow> omitted;
    std::vector<PrecisionFinding> precision; ///< of the per-pixel rows
    /// Empty: the truth is the analytic surface; else why it is the finest mesh's.
    std::string no_analytic_surface;
    bool finished = false; ///< false: stopped half-way; what was measured is here
    Accounting seconds;
};

/// How a row is drawn: by the renderer, or by a fake in a test.
struct DrawRows {
    Load load;
    /// The picture with object ids. Throws InputError where the technique is refused for the scene.
    std::function<Frame(const Scene &, const Technique &)> picture;
    /// Draws without object ids and without reading back, waits until done; milliseconds.
    std::function<double(const Scene &, const Technique &)> timed;
    /// With a fragment stage declared mediump; empty where the device knows no precision.
    std::function<Image(const Scene &, const Technique &)> mediump{};
    /// While what it returns lives, nothing that a frame is drawn with is made twice; may be empty.
    std::function<std::shared_ptr<const void>()> keep_all{};
};

/// Finds the errors first, once per row; then draws every row once a round, drops `options.warm_ups` rounds and keeps
/// `options.repeats`. If `progress` returns false, the work stops and the result is marked unfinished.
WorkPrecision measure_work_precision(const Scene &scene, const PlanOptions &options, const DrawRows &draw,
                                     const Progress &progress = {});

/// The truth that a row of this model is judged against: per-pixel, every fault off, on the analytic surface or, where
/// `analytic` is false, on the last of `meshes`, the finest.
ReferenceFrame report_truth(Model model, bool analytic, const std::vector<PlannedMesh> &meshes, Size size,
                            const Load &load, const Progress &progress = {});

/// Draws with render/'s Renderer, which this room cannot name. Pictures have the size of `target`; frames are timed by
/// `clock` (FrameClock). All three must outlive what is returned.
template <typename Renderer, typename Target, typename Clock>
DrawRows rows_drawn_by(Renderer &renderer, Target &target, Clock &clock) {
    DrawRows draw{
        [&](const Scene &s) { return renderer.resources().load(s); },
        [&](const Scene &s, const Technique &t) { return renderer.render(s, t, target.size(), true); },
        [&](const Scene &s, const Technique &t) { return clock.milliseconds([&] { renderer.draw(s, t, target); }); },
        {},
        [&] { return renderer.keep_all(); }};
    if (Renderer::knows_precision()) {
        draw.mediump = [&](const Scene &s, const Technique &t) {
            renderer.draw_mediump(s, t, target);
            return target.read_color();
        };
    }
    return draw;
}

} // namespace sandbox

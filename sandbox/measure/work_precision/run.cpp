#include "measure/work_precision/run.h"

#include "image/error.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <stdexcept>

namespace sandbox {
namespace {

using Clock = std::chrono::steady_clock;

/// Adds its lifetime to a sum of seconds.
class Stopwatch {
  public:
    explicit Stopwatch(double &seconds) : seconds_(seconds), start_(Clock::now()) {}
    ~Stopwatch() { seconds_ += std::chrono::duration<double>(Clock::now() - start_).count(); }
    Stopwatch(const Stopwatch &) = delete;
    Stopwatch &operator=(const Stopwatch &) = delete;

  private:
    double &seconds_;
    Clock::time_point start_;
};

Technique truth_technique(Model model) { return {.frequency = Frequency::per_pixel, .model = model}; }

/// Drops the keys that do not change the reference.
Technique as_referenced(Technique technique) {
    technique.power = Power::automatic;
    technique.precision = Precision::high;
    technique.program = Program::specialised;
    return technique;
}

class Measurement {
  public:
    Measurement(WorkPrecision &result, const DrawRows &draw, const Progress &progress)
        : result_(result), draw_(draw), progress_(progress) {
        const Plan plan = plan_report(result.scene, result.options, draw.load);
        result.meshes = plan.meshes;
        result.omitted = plan.omitted;
        for (const PlannedRow &row : plan.rows) {
            result.rows.push_back({row, {}, {}, {}});
        }
        for (const PlannedMesh &mesh : result.meshes) {
            resources_.push_back(draw.load(mesh.scene)); // held to the end, so that no mesh is built twice
        }
    }

    /// Throws Cancelled.
    void run() {
        const std::shared_ptr<const void> kept = draw_.keep_all ? draw_.keep_all() : nullptr;
        find_truths();
        for (std::size_t i = 0; i < result_.rows.size(); ++i) {
            report(errors_share * static_cast<double>(i) / static_cast<double>(result_.rows.size()));
            judge(result_.rows[i]);
        }
        frames_.clear();
        find_precisions();
        take_turns();
    }

    /// Keeps the times of all rounds so far.
    void keep_times() {
        for (std::size_t i = 0; i < result_.rows.size() && i < samples_.size(); ++i) {
            if (!samples_[i].empty()) {
                result_.rows[i].time = run_time(samples_[i]);
            }
        }
    }

  private:
    static constexpr double errors_share = 0.4; ///< of the progress; a guess, since scenes differ
    static constexpr int precision_width = 160; ///< pixels: a search draws some fifty pictures

    void report(double share) {
        share_ = share;
        if (progress_ && !progress_(share)) {
            throw Cancelled();
        }
    }
    /// Lets long work be stopped without moving the bar.
    [[nodiscard]] Progress stoppable() const {
        return progress_ ? Progress([this](double) { return progress_(share_); }) : Progress();
    }

    void find_truths() {
        const Stopwatch watch(result_.seconds.reference);
        bool analytic = true;
        for (const MeasuredRow &row : result_.rows) {
            const Model model = row.plan.technique.model;
            if (truths_.contains(model)) {
                continue;
            }
            try {
                truths_[model] = truth(model, analytic);
            } catch (const InputError &why) {
                if (!analytic) {
                    throw;
                }
                analytic = false;
                result_.no_analytic_surface = why.what();
                truths_[model] = truth(model, analytic);
            }
        }
    }
    [[nodiscard]] ReferenceFrame truth(Model model, bool analytic) const {
        return report_truth(model, analytic, result_.meshes, result_.options.size, draw_.load, stoppable());
    }

    void judge(MeasuredRow &row) {
        const PlannedMesh &mesh = result_.meshes[row.plan.mesh];
        Frame drawn;
        try {
            const Stopwatch watch(result_.seconds.drawing);
            drawn = draw_.picture(mesh.scene, row.plan.technique);
        } catch (const InputError &why) {
            row.refused = why.what();
            return;
        }
        const Model model = row.plan.technique.model;
        const ReferenceFrame &technique = reference(row.plan.mesh, row.plan.technique);
        const ReferenceFrame &per_pixel = reference(row.plan.mesh, truth_technique(model));
        const Stopwatch watch(result_.seconds.metrics);
        const ReferenceFrame &truth = truths_.at(model);
        auto &geometry = geometry_[model];
        RowErrors errors;
        parallel_for(2, [&](std::size_t part) {
            if (part == 0) {
                errors.total = compare(drawn, truth, Flip::without);
            } else {
                errors.split = split_error(drawn, technique, per_pixel, &truth, geometry);
            }
        });
        row.errors = errors;
        geometry = row.errors->split.geometry;
        if (row.plan.technique.frequency == Frequency::automatic) {
            row.certificate =
                certificate_figures(mesh.scene, resources_[row.plan.mesh], row.plan.technique, technique, per_pixel);
        }
    }

    /// The double picture on a mesh; those of the last mesh are kept.
    const ReferenceFrame &reference(std::size_t mesh, const Technique &technique) {
        if (mesh != frames_mesh_) {
            frames_.clear();
            geometry_.clear();
            frames_mesh_ = mesh;
        }
        auto &frame = frames_[to_string(as_referenced(technique))];
        if (frame.color.empty()) {
            const Stopwatch watch(result_.seconds.reference);
            frame = render_reference(result_.meshes[mesh].scene, resources_[mesh], as_referenced(technique),
                                     result_.options.size, Surface::mesh, stoppable());
        }
        return frame;
    }

    /// Of every model, per pixel, on the scene's own mesh.
    void find_precisions() {
        for (const MeasuredRow &row : result_.rows) {
            const PlannedMesh &mesh = result_.meshes[row.plan.mesh];
            Technique high = row.plan.technique;
            high.precision = Precision::high;
            if (!mesh.own || !row.errors || row.plan.group != RowGroup::precision) {
                continue;
            }
            report(share_);
            const Stopwatch watch(result_.seconds.reference);
            const Size size = result_.options.size;
            const int width = std::min(size.width, precision_width);
            PrecisionFinding finding = find_precision(mesh.scene, resources_[row.plan.mesh], high,
                                                      {width, std::max(size.height * width / size.width, 1)});
            if (draw_.mediump) {
                finding.device = levels_between(draw_.mediump(mesh.scene, high), draw_.picture(mesh.scene, high).color);
            }
            result_.precision.push_back(std::move(finding));
        }
    }

    void take_turns() {
        samples_.resize(result_.rows.size());
        const int rounds = result_.options.warm_ups + result_.options.repeats;
        for (int round = 0; round < rounds; ++round) {
            for (std::size_t i = 0; i < result_.rows.size(); ++i) {
                const double done = round + static_cast<double>(i) / static_cast<double>(result_.rows.size());
                report(errors_share + (1 - errors_share) * done / rounds);
                const MeasuredRow &row = result_.rows[i];
                if (!row.refused.empty()) {
                    continue;
                }
                const Stopwatch watch(result_.seconds.drawing);
                const double ms = draw_.timed(result_.meshes[row.plan.mesh].scene, row.plan.technique);
                if (round >= result_.options.warm_ups) {
                    samples_[i].push_back(ms);
                }
            }
        }
    }

    WorkPrecision &result_;
    const DrawRows &draw_;
    const Progress &progress_;
    double share_ = 0;
    std::vector<std::vector<ObjectResources>> resources_; ///< by mesh
    std::map<Model, ReferenceFrame> truths_;
    std::map<std::string, ReferenceFrame> frames_;   ///< of frames_mesh_, by technique
    std::map<Model, std::optional<Norms>> geometry_; ///< of frames_mesh_
    std::size_t frames_mesh_ = 0;
    std::vector<std::vector<double>> samples_; ///< by row
};

/// Interpolates between the two samples around the rank.
double quantile(const std::vector<double> &sorted, double share) {
    const double rank = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(rank);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (rank - std::floor(rank)) * (sorted[above] - sorted[below]);
}

} // namespace

RunTime run_time(std::vector<double> samples) {
    if (samples.empty()) {
        throw std::invalid_argument("run_time: no samples");
    }
    std::vector<double> sorted = samples;
    std::ranges::sort(sorted);
    return {std::move(samples), sorted.front(), quantile(sorted, 0.25), quantile(sorted, 0.5), quantile(sorted, 0.75)};
}

ReferenceFrame report_truth(Model model, bool analytic, const std::vector<PlannedMesh> &meshes, Size size,
                            const Load &load, const Progress &progress) {
    const Scene &scene = meshes.back().scene;
    return render_reference(scene, load(scene), truth_technique(model), size,
                            analytic ? Surface::analytic : Surface::mesh, progress);
}

WorkPrecision measure_work_precision(const Scene &scene, const PlanOptions &options, const DrawRows &draw,
                                     const Progress &progress) {
    const Clock::time_point start = Clock::now();
    WorkPrecision result;
    result.scene = scene;
    result.options = options;
    Measurement measurement(result, draw, progress);
    try {
        measurement.run();
        result.finished = true;
    } catch (const Cancelled &) {
        // what was measured is kept
    }
    measurement.keep_times();
    Accounting &seconds = result.seconds;
    seconds.other = std::chrono::duration<double>(Clock::now() - start).count() - seconds.drawing - seconds.reference -
                    seconds.metrics;
    return result;
}

} // namespace sandbox

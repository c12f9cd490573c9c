#include "ui/jobs/side_findings.h"

#include "capture/picture.h"
#include "image/difference.h"
#include "image/error.h"
#include "measure/stability/textbook.h"
#include "measure/work_precision/precision.h"
#include "reference/reference.h"
#include "render/context.h"
#include "render/frame_clock.h"

#include <algorithm>
#include <chrono>

namespace sandbox {

namespace {

constexpr int estimate_divisor = 4;     ///< of width and height
constexpr int least_estimate_side = 48; ///< smaller pictures say little
constexpr int timed_frames = 20;
constexpr std::size_t fewest_times = 8; ///< of which a median says something
constexpr std::chrono::milliseconds longest_timing{1200};

/// Both sides' pictures and truths at one size.
struct Drawn {
    std::array<std::optional<Frame>, 2> frames;
    std::array<std::shared_ptr<ReferenceFrame>, 2> truths;
};

class Finder {
  public:
    Finder(const SidesShown &shown, DrawingTurn &turn, JobReporter &reporter)
        : shown_(shown), turn_(turn), renderer_(turn.renderer()),
          reporter_(reporter), scenes_{shown.scene_of(false), shown.scene_of(true)},
          resources_{renderer_.resources().load(scenes_[0]), renderer_.resources().load(scenes_[1])} {}

    [[nodiscard]] bool stopped() const { return reporter_.cancelled(); }

    /// Throws Cancelled.
    void compare_at(Size size, bool estimate, Findings &findings) {
        Drawn drawn;
        for (const bool right : {false, true}) {
            SideFindings &side = findings.sides[right ? 1 : 0];
            side.failure.clear();
            turn_.let_others_draw();
            try {
                drawn.frames[right ? 1 : 0] = picture(right, size);
                drawn.truths[right ? 1 : 0] =
                    right && shown_.one_truth() && drawn.truths[0] ? drawn.truths[0] : truth(right, size);
                side.device = device_levels(right, size);
            } catch (const InputError &error) {
                side.failure = error.what();
            } catch (const MachineError &error) {
                side.failure = error.what();
            }
            if (side.failure.empty()) {
                judge(*drawn.frames[right ? 1 : 0], *drawn.truths[right ? 1 : 0], estimate, side);
            }
        }
        if (!estimate && drawn.frames[0] && drawn.frames[1]) {
            findings.apart = largest_difference(drawn.frames[0]->color, drawn.frames[1]->color);
        }
    }

    /// In turns, so that whatever slows the machine slows both.
    void take_times(Findings &findings) {
        Target target(shown_.size);
        const std::shared_ptr<const void> kept = renderer_.keep_all(); // others draw in between
        std::array<std::vector<double>, 2> samples;
        FrameClock clock(Context::software(), target, [&] { renderer_.draw(scenes_[1], technique(true), target); });
        const auto end = std::chrono::steady_clock::now() + longest_timing;
        for (int round = -1; round < timed_frames && !stopped() && std::chrono::steady_clock::now() < end; ++round) {
            turn_.let_others_draw();
            for (const bool right : {false, true}) {
                if (!findings.sides[right ? 1 : 0].failure.empty() || (!right && shown_.textbook_left)) {
                    continue;
                }
                const bool apart = technique(right).model == Model::own; // its own process takes the time
                const double ms =
                    apart ? renderer_.render(scene(right), technique(right), shown_.size).milliseconds
                          : clock.milliseconds([&] { renderer_.draw(scene(right), technique(right), target); });
                if (round >= 0) { // the first warms up
                    samples[right ? 1 : 0].push_back(ms);
                }
            }
        }
        for (const std::size_t side : {0U, 1U}) {
            if (samples[side].size() >= fewest_times) {
                findings.sides[side].time = run_time(std::move(samples[side]));
            }
        }
    }

  private:
    [[nodiscard]] const Technique &technique(bool right) const { return right ? shown_.right : shown_.left; }

    [[nodiscard]] const Scene &scene(bool right) const { return scenes_[right ? 1 : 0]; }

    [[nodiscard]] Frame picture(bool right, Size size) {
        return !right && shown_.textbook_left ? textbook_picture(scene(right), resources_[0], shown_.left, size)
                                              : renderer_.render(scene(right), technique(right), size, true);
    }

    [[nodiscard]] std::shared_ptr<ReferenceFrame> truth(bool right, Size size) {
        return std::make_shared<ReferenceFrame>(render_reference(scene(right), resources_[right ? 1 : 0],
                                                                 shown_.truth_of_side(right), size, Surface::mesh,
                                                                 [this](double) { return !stopped(); }));
    }

    [[nodiscard]] std::optional<double> device_levels(bool right, Size size) {
        Technique high = part_of_auto(technique(right), Frequency::per_pixel);
        const bool textbook = !right && shown_.textbook_left;
        if (high.precision == Precision::high || high.model == Model::own || textbook || !Renderer::knows_precision()) {
            return std::nullopt;
        }
        high.precision = Precision::high;
        Target target(size);
        renderer_.draw_mediump(scene(right), high, target);
        const Image medium = target.read_color();
        renderer_.draw(scene(right), high, target);
        return levels_between(medium, target.read_color());
    }

    static void judge(const Frame &drawn, const ReferenceFrame &truth, bool estimate, SideFindings &side) {
        side.metrics = compare(drawn, truth, Flip::without);
        side.estimate = estimate;
        if (!estimate) {
            side.truth = std::make_shared<Image>(to_frame(truth).color);
            side.uses = pixel_uses(drawn.object_ids, truth);
        }
    }

    const SidesShown &shown_;
    DrawingTurn &turn_;
    Renderer &renderer_;
    JobReporter &reporter_;
    std::array<Scene, 2> scenes_;
    std::array<std::vector<ObjectResources>, 2> resources_; ///< held: neither side's meshes evict the other's
};

} // namespace

void find_errors(const SidesShown &shown, DrawingTurn &turn, JobReporter &reporter,
                 const std::function<void(const Findings &)> &publish) {
    Finder finder(shown, turn, reporter);
    Findings findings{shown, {}, {}};
    const Size small{shown.size.width / estimate_divisor, shown.size.height / estimate_divisor};
    if (std::min(small.width, small.height) >= least_estimate_side) {
        finder.compare_at(small, true, findings);
        publish(findings);
    }
    finder.compare_at(shown.size, false, findings);
    publish(findings);
}

bool find_times(Findings &findings, DrawingTurn &turn, JobReporter &reporter) {
    Finder finder(findings.of, turn, reporter);
    finder.take_times(findings);
    return !finder.stopped();
}

} // namespace sandbox

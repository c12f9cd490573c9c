#include "ui/jobs/stability_job.h"

#include <utility>

namespace sandbox {

StabilityJob::StabilityJob(const DrawingSupplies &supplies, std::vector<StabilityCase> cases)
    : cases_(std::move(cases)),
      drawing_(supplies, [this](DrawingTurn &turn, JobReporter &reporter) { return run(turn, reporter); }) {}

StabilityJob::Nothing StabilityJob::run(DrawingTurn &turn, JobReporter &reporter) {
    Target target(stability_timed_size);
    const StabilityDraw draw = cases_drawn_by(turn.renderer(), target);
    for (std::size_t i = 0; i < cases_.size(); ++i) {
        turn.let_others_draw();
        reporter.say(cases_[i].name);
        if (!reporter.report(static_cast<double>(i) / static_cast<double>(cases_.size()))) {
            break;
        }
        StabilityResult result = run_stability_case(cases_[i], draw);
        const std::lock_guard lock(mutex_);
        finished_.push_back(std::move(result));
    }
    return {};
}

std::vector<StabilityResult> StabilityJob::take_finished() {
    const std::lock_guard lock(mutex_);
    return std::exchange(finished_, {});
}

} // namespace sandbox

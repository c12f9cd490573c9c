#include "ui/jobs/claims_job.h"

namespace sandbox {

ClaimsJob::ClaimsJob(const DrawingSupplies &supplies, const std::shared_ptr<const ShownStep> &shown, const Words &words)
    : shared_(std::make_shared<Shared>()) {
    const auto work = [shared = shared_, shown, words](DrawingTurn &turn, JobReporter &reporter) {
        LessonDraw draw = lessons_drawn_by(turn.renderer());
        draw.words = words;
        draw.picture = [&, picture = draw.picture](const Scene &scene, const Technique &technique, Size size) {
            turn.let_others_draw();
            return reporter.cancelled() ? throw Cancelled() : picture(scene, technique, size);
        };
        measure_step(shown->step(), draw, [&](const ClaimResult &result) {
            {
                const std::lock_guard lock(shared->mutex);
                shared->results.push_back(result);
            }
            reporter.wake();
        });
        return true;
    };
    job_ = std::make_unique<DrawingJob<bool>>(supplies, work);
}

std::vector<ClaimResult> ClaimsJob::results() const {
    const std::lock_guard lock(shared_->mutex);
    return shared_->results;
}

} // namespace sandbox

#pragma once

#include "teach/claims.h"
#include "ui/jobs/drawing_job.h"
#include "ui/session/shown_lesson.h"

#include <memory>
#include <mutex>
#include <vector>

namespace sandbox {

/// Measures the claims of a lesson's step, one after the other. All member functions are for the main thread.
class ClaimsJob {
  public:
    /// Throws MachineError (see BackgroundRenderer::make_context).
    ClaimsJob(const DrawingSupplies &supplies, const std::shared_ptr<const ShownStep> &shown, const Words &words);
    /// As far as it has come, in the order of the claims.
    [[nodiscard]] std::vector<ClaimResult> results() const;
    [[nodiscard]] BackgroundJob &job() { return job_->job(); }

  private:
    struct Shared {
        mutable std::mutex mutex;
        std::vector<ClaimResult> results; ///< guarded by mutex
    };
    std::shared_ptr<Shared> shared_;
    std::unique_ptr<DrawingJob<bool>> job_; ///< last: ends before what it uses
};

} // namespace sandbox

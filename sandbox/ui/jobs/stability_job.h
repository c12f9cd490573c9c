#pragma once

#include "measure/stability/stability.h"
#include "ui/jobs/drawing_job.h"

#include <mutex>
#include <vector>

namespace sandbox {

/// Runs cases in the background; hands out their results one by one.
class StabilityJob {
  public:
    /// Starts at once. Throws MachineError (see BackgroundRenderer::make_context).
    StabilityJob(const DrawingSupplies &supplies, std::vector<StabilityCase> cases);

    /// What was finished since the last call.
    std::vector<StabilityResult> take_finished();
    [[nodiscard]] BackgroundJob &job() { return drawing_.job(); }

  private:
    struct Nothing {};
    Nothing run(DrawingTurn &turn, JobReporter &reporter);

    std::vector<StabilityCase> cases_;
    std::mutex mutex_;
    std::vector<StabilityResult> finished_; ///< guarded by mutex_
    DrawingJob<Nothing> drawing_;           ///< last: ends before what it uses
};

} // namespace sandbox

#pragma once

#include "ui/jobs/drawing_job.h"
#include "ui/jobs/stability_list.h"

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace sandbox {

/// Runs cases beside the window; their results can be had one by one.
class StabilityJob {
  public:
    /// `cases` with their numbers in the list. Starts at once. Throws MachineError (see WorkerContext).
    StabilityJob(const DrawingSupplies &supplies, std::vector<std::pair<std::size_t, StabilityCase>> cases);

    /// What was finished since the last call, with its number in the list.
    std::vector<std::pair<std::size_t, StabilityResult>> take_finished();
    [[nodiscard]] BackgroundJob &job() { return drawing_.job(); }

  private:
    struct Nothing {};
    Nothing run(Renderer &renderer, JobReporter &reporter);

    std::vector<std::pair<std::size_t, StabilityCase>> cases_;
    std::mutex mutex_;
    std::vector<std::pair<std::size_t, StabilityResult>> finished_; ///< guarded by mutex_
    DrawingJob<Nothing> drawing_;                                   ///< last: ends before what it uses
};

} // namespace sandbox

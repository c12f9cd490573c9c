#pragma once

#include "capture/sidecar.h"
#include "render/context.h"
#include "render/renderer.h"
#include "scene/assets.h"
#include "ui/jobs/background_job.h"
#include "ui/session/session.h"

#include <functional>
#include <memory>
#include <optional>
#include <utility>

namespace sandbox {

/// What jobs that draw are made with.
struct DrawingSupplies {
    Assets assets, shaders;
    DrawnBy by;             ///< the OpenGL of the window and of its jobs
    const Context *context; ///< the window's
};

/// Ends the window's waiting for events; from any thread.
void wake_window();

/// One row in the current ImGui window: "Cancel", how far the job is, what it is doing.
void job_progress_row(Session &session, BackgroundJob &job);

/// Work on its own thread with its own renderer. All member functions are for the main thread.
template <typename Result> class DrawingJob {
  public:
    using Work = std::function<Result(Renderer &, JobReporter &)>;

    DrawingJob(DrawingSupplies supplies, Work work)
        : context_(supplies.context->make_worker()),
          job_(
              [this, supplies = std::move(supplies), work = std::move(work)](JobReporter &reporter) {
                  const WorkerContext::Current current(*context_);
                  Renderer renderer(supplies.assets, ShaderParts(supplies.shaders));
                  result_ = work(renderer, reporter);
              },
              wake_window) {}

    [[nodiscard]] BackgroundJob &job() { return job_; }
    /// Once the job is done.
    [[nodiscard]] Result take_result() { return std::move(*result_); }

  private:
    std::unique_ptr<WorkerContext> context_;
    std::optional<Result> result_;
    BackgroundJob job_; ///< last: ends before what it uses
};

} // namespace sandbox

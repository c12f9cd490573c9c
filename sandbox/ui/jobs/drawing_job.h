#pragma once

#include "capture/sidecar.h"
#include "reference/parallel.h"
#include "render/background_renderer.h"
#include "ui/jobs/background_job.h"
#include "ui/session/session.h"

#include <functional>
#include <memory>
#include <optional>
#include <utility>

namespace sandbox {

/// What jobs that draw are made with.
struct DrawingSupplies {
    BackgroundRenderer *shared;
    DrawnBy by; ///< the OpenGL of the window and of its jobs
};

/// Ends the window's waiting for events; from any thread.
void wake_window();

/// One row in the current ImGui window: "Cancel", how far the job is, what it is doing.
void job_progress_row(Session &session, BackgroundJob &job);

using DrawingTurn = BackgroundRenderer::Turn;

/// Work on its own thread, when its turn to draw has come. All member functions are for the main thread.
template <typename Result> class DrawingJob {
  public:
    /// Long work lets others draw between its pictures.
    using Work = std::function<Result(DrawingTurn &, JobReporter &)>;

    /// Throws MachineError (see BackgroundRenderer::make_context).
    DrawingJob(const DrawingSupplies &supplies, Work work,
               BackgroundRenderer::Broken broken = BackgroundRenderer::Broken::fails)
        : job_(
              [this, broken, &shared = with_context(*supplies.shared), work = std::move(work)](JobReporter &reporter) {
                  try {
                      if (DrawingTurn turn(shared, reporter.stop_token(), broken); turn) {
                          result_ = work(turn, reporter);
                      }
                  } catch (const Cancelled &) {
                      result_.reset();
                  }
              },
              wake_window) {}

    [[nodiscard]] BackgroundJob &job() { return job_; }
    /// Once the job is done; nothing if it was cancelled before there was any.
    [[nodiscard]] std::optional<Result> take_result() { return std::move(result_); }

  private:
    static BackgroundRenderer &with_context(BackgroundRenderer &shared) {
        shared.make_context();
        return shared;
    }

    std::optional<Result> result_;
    BackgroundJob job_; ///< last: ends before what it uses
};

} // namespace sandbox

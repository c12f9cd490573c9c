#pragma once

#include "capture/sidecar.h"
#include "render/renderer.h"
#include "scene/assets.h"
#include "ui/jobs/background_job.h"
#include "ui/session/session.h"

#include <functional>
#include <optional>
#include <utility>

struct GLFWwindow;

namespace sandbox {

/// What jobs that draw are made with.
struct DrawingSupplies {
    Assets assets, shaders;
    DrawnBy by; ///< the OpenGL of the window and of its jobs
};

/// An OpenGL context for one more thread: that of a hidden window, made and destroyed on the main thread. Throws
/// MachineError where there can be no second context.
class WorkerContext {
  public:
    WorkerContext();
    ~WorkerContext();
    WorkerContext(const WorkerContext &) = delete;
    WorkerContext &operator=(const WorkerContext &) = delete;

    /// While it lives, the calling thread draws in this context, with the OpenGL functions that the window loaded: the
    /// driver is the same.
    class Current {
      public:
        explicit Current(const WorkerContext &context);
        ~Current();
        Current(const Current &) = delete;
        Current &operator=(const Current &) = delete;
    };

  private:
    GLFWwindow *window_ = nullptr;
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
        : job_(
              [this, supplies = std::move(supplies), work = std::move(work)](JobReporter &reporter) {
                  const WorkerContext::Current current(context_);
                  Renderer renderer(supplies.assets, ShaderParts(supplies.shaders));
                  result_ = work(renderer, reporter);
              },
              wake_window) {}

    [[nodiscard]] BackgroundJob &job() { return job_; }
    /// Once the job is done.
    [[nodiscard]] Result take_result() { return std::move(*result_); }

  private:
    WorkerContext context_;
    std::optional<Result> result_;
    BackgroundJob job_; ///< last: ends before what it uses
};

} // namespace sandbox

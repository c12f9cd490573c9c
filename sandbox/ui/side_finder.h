#pragma once

#include "ui/jobs/drawing_job.h"
#include "ui/session/findings.h"
#include "ui/views/view_painter.h"

#include <functional>
#include <memory>
#include <mutex>
#include <optional>

namespace sandbox {

/// In the background, with a renderer of its own: makes the pictures that the painter awaits and, while nothing is
/// dragged and nothing plays, finds out about both sides. What is out of date is stopped.
class SideFinder {
  public:
    explicit SideFinder(DrawingSupplies supplies) : supplies_(std::move(supplies)) {}
    ~SideFinder();
    SideFinder(const SideFinder &) = delete;
    SideFinder &operator=(const SideFinder &) = delete;

    /// Before a frame: starts what is wanted; hands the painter what has been found out about what is shown.
    void update(const Session &session, ViewPainter &painter);
    /// Of the job since the last call.
    News take_news();
    [[nodiscard]] bool busy() const { return job_ != nullptr; }

  private:
    using Work = std::function<void(Renderer &, JobReporter &)>;
    bool start_job(Work work);
    void start(const SidesShown &shown);
    void start_making(const SlowPicture &picture);

    DrawingSupplies supplies_;
    std::unique_ptr<WorkerContext> context_;
    std::unique_ptr<Renderer> renderer_; ///< lives in that context
    bool impossible_ = false;            ///< there can be no second context
    std::optional<SidesShown> wanted_, started_;
    std::optional<SlowPicture> made_; ///< or being made by the job
    std::optional<Image> made_image_; ///< the job's, until it has ended
    std::mutex mutex_;
    std::shared_ptr<const Findings> found_; ///< guarded by mutex_; of started_
    std::unique_ptr<BackgroundJob> job_;    ///< while one runs; last: ends before what it uses
};

} // namespace sandbox

#pragma once

#include "ui/jobs/drawing_job.h"
#include "ui/session/findings.h"
#include "ui/views/view_painter.h"

#include <memory>
#include <mutex>
#include <optional>

namespace sandbox {

/// Finds out about both sides in the background, with a renderer of its own, while nothing is dragged and nothing
/// plays. What is out of date is stopped.
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
    void start(const SidesShown &shown);

    DrawingSupplies supplies_;
    std::unique_ptr<WorkerContext> context_;
    std::unique_ptr<Renderer> renderer_; ///< lives in that context
    bool impossible_ = false;            ///< there can be no second context
    std::optional<SidesShown> wanted_, started_;
    std::mutex mutex_;
    std::shared_ptr<const Findings> found_; ///< guarded by mutex_; of started_
    std::unique_ptr<BackgroundJob> job_;    ///< while one runs; last: ends before what it uses
};

} // namespace sandbox

#pragma once

#include "ui/jobs/drawing_job.h"
#include "ui/session/findings.h"
#include "ui/views/view_painter.h"

#include <functional>
#include <memory>
#include <mutex>
#include <optional>

namespace sandbox {

/// In the background: makes the pictures that the painter awaits and, while nothing is dragged and nothing plays, finds
/// both sides' errors, then builds what the lesson's next step draws with, smooths the pictures, and takes run times.
/// What is out of date is stopped.
class SideFinder {
  public:
    explicit SideFinder(DrawingSupplies supplies) : supplies_(std::move(supplies)) {}

    /// Before a frame: starts what is wanted; hands the painter what has been found out about what is shown.
    void update(const Session &session, ViewPainter &painter);
    /// Of the job since the last call.
    News take_news();
    [[nodiscard]] bool busy() const { return job_ != nullptr; }

  private:
    enum class Task { making, errors, smoothing, times };
    using Work = std::function<void(DrawingTurn &, JobReporter &)>;
    bool start_job(Task task, Work work);
    void start_making(const SlowPicture &picture);
    void find_errors_of(const SidesShown &shown);
    void smooth(const ViewKeys &keys);
    void find_times_of(const SidesShown &shown);
    std::optional<SlowPicture> ahead(const Session &session, ViewPainter &painter);
    void end_job(ViewPainter &painter);
    void cancel_job();

    DrawingSupplies supplies_;
    bool impossible_ = false; ///< there can be no second context
    /// What has been done, or is being done by the job.
    std::optional<SlowPicture> made_;
    std::optional<SidesShown> judged_, timed_;
    std::optional<ViewKeys> smoothed_;
    std::shared_ptr<const ShownStep> ahead_of_; ///< the step whose next one has been made ahead
    MadePicture made_picture_;                  ///< the job's, until it has ended
    std::mutex mutex_;
    std::shared_ptr<const Findings> found_;        ///< guarded by mutex_; of judged_
    std::shared_ptr<const SmoothPictures> smooth_; ///< guarded by mutex_; of smoothed_
    Task task_ = Task::making;                     ///< the job's
    std::unique_ptr<DrawingJob<bool>> job_;        ///< while one runs; last: ends before what it uses
};

} // namespace sandbox

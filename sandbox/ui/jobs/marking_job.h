#pragma once

#include "teach/marking/marker.h"
#include "ui/jobs/drawing_job.h"

#include <memory>
#include <optional>

namespace sandbox {

/// Marks a student's texts for one exercise, one after the other: what is right is worked out once. All member
/// functions are for the main thread.
class ExerciseMarker {
  public:
    ExerciseMarker(DrawingSupplies supplies, std::shared_ptr<const Exercise> exercise);

    /// Stops what it does and begins with this text. Throws MachineError (see BackgroundRenderer::make_context).
    void mark(const OwnShader &text);
    [[nodiscard]] bool busy() const { return job_ != nullptr; }
    /// Of the job since the last call; after News::result, result() or failure() have changed.
    News take_news();

    /// The last one, with the text that it is of.
    struct Result {
        OwnShader text;
        Mark mark;
    };
    [[nodiscard]] const std::optional<Result> &result() const { return result_; }
    /// Why the last text could not be marked, by no fault of its own; empty: it could.
    [[nodiscard]] const std::string &failure() const { return failure_; }

  private:
    struct Work;
    DrawingSupplies supplies_;
    std::shared_ptr<Work> work_;
    OwnShader marks_; ///< the job's
    std::optional<Result> result_;
    std::string failure_;
    std::unique_ptr<DrawingJob<Mark>> job_; ///< while one runs; last: ends before what it uses
};

} // namespace sandbox

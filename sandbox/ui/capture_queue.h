#pragma once

#include "capture/picture.h"
#include "ui/jobs/drawing_job.h"

#include <cstddef>
#include <deque>
#include <optional>
#include <string>

namespace sandbox {

/// A picture that the views show, to be written.
struct ShownPicture {
    std::string name; ///< its file's, without number and ending
    Scene scene;      ///< as seen, so that the sidecar alone gives the same picture
    PictureOptions options;
};

constexpr std::size_t most_waiting_captures = 8;

/// Writes pictures and their sidecars into the folder of captures one after another, aside, for a truth in one takes a
/// while. All member functions are for the main thread.
class CaptureQueue {
  public:
    /// `own` draws where there can be no second context; it must outlive this.
    CaptureQueue(DrawingSupplies supplies, Renderer &own) : supplies_(std::move(supplies)), own_(own) {}
    /// Writes what still waits.
    ~CaptureQueue();
    CaptureQueue(const CaptureQueue &) = delete;
    CaptureQueue &operator=(const CaptureQueue &) = delete;

    /// Throws InputError where most_waiting_captures wait already.
    void add(ShownPicture picture);
    /// Behind the one that is being written.
    [[nodiscard]] std::size_t waiting() const { return waiting_.size(); }
    [[nodiscard]] bool busy() const { return job_.has_value() || outcome_.has_value(); }

    struct Outcome {
        std::string path, failure; ///< one of them is empty
    };
    /// Of the last picture, once; the next one is then begun.
    std::optional<Outcome> take_outcome();

  private:
    void begin_next();

    DrawingSupplies supplies_;
    Renderer &own_;
    std::deque<ShownPicture> waiting_;
    std::optional<Outcome> outcome_;
    std::optional<DrawingJob<std::string>> job_; ///< gives the file's path; last: ends before what it uses
};

} // namespace sandbox

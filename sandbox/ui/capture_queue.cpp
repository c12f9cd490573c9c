#include "ui/capture_queue.h"

#include "capture/sidecar.h"
#include "image/error.h"
#include "image/image_file.h"
#include "ui/session/written_files.h"
#include "ui/views/painters.h"

#include <exception>
#include <filesystem>
#include <utility>
#include <vector>

namespace sandbox {

namespace {

/// Returns the file's path. Throws InputError.
std::string write_picture(const ShownPicture &picture, Renderer &renderer, const DrawnBy &by) {
    const auto path = std::filesystem::absolute(free_name(capture_folder(), picture.name));
    const Painters painters = painters_of(renderer, on_surfaces(picture.options.drawn_over, picture.options.layout));
    write_files(std::vector<OutputFile>{
        {path, encode_png(show_picture(picture.scene, picture.options, painters))},
        {sidecar_path(path), sidecar_text(picture.scene, picture.options, by, path.parent_path())}});
    return path.string();
}

} // namespace

CaptureQueue::~CaptureQueue() {
    while (job_ || !waiting_.empty()) {
        if (job_) {
            job_->job().wait();
            job_.reset();
        }
        begin_next();
    }
}

void CaptureQueue::add(ShownPicture picture) {
    if (waiting_.size() >= most_waiting_captures) {
        throw InputError("{} captures wait to be written; this one is left out", waiting_.size());
    }
    waiting_.push_back(std::move(picture));
    if (!busy()) {
        begin_next();
    }
}

/// Does nothing if none waits.
void CaptureQueue::begin_next() {
    if (waiting_.empty()) {
        return;
    }
    const ShownPicture picture = std::move(waiting_.front());
    waiting_.pop_front();
    try {
        job_.emplace(supplies_, [picture, by = supplies_.by](DrawingTurn &turn, JobReporter & /*reporter*/) {
            return write_picture(picture, turn.renderer(), by);
        });
    } catch (const MachineError &) { // there can be no second context
        try {
            outcome_ = Outcome{write_picture(picture, own_, supplies_.by), ""};
        } catch (const std::exception &failed) {
            outcome_ = Outcome{"", failed.what()};
        }
    }
}

std::optional<CaptureQueue::Outcome> CaptureQueue::take_outcome() {
    if (job_ && job_->job().state() != JobState::running) {
        const bool done = job_->job().state() == JobState::done;
        outcome_ = done ? Outcome{job_->take_result().value_or(""), ""} : Outcome{"", job_->job().error()};
        job_.reset();
    }
    std::optional<Outcome> outcome = std::exchange(outcome_, std::nullopt);
    if (outcome) {
        begin_next();
    }
    return outcome;
}

} // namespace sandbox

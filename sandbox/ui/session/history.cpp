#include "ui/session/history.h"

namespace sandbox {

namespace {

bool only_camera_differs(const Document &a, const Document &b) {
    Document moved = a;
    moved.scene.camera = b.scene.camera;
    return moved == b && a.scene.camera != b.scene.camera;
}

} // namespace

void History::record(const Document &now) {
    if (now == current()) {
        return;
    }
    steps_.resize(at_ + 1);
    const bool goes_on_moving =
        at_ > 0 && only_camera_differs(steps_[at_ - 1], steps_[at_]) && only_camera_differs(steps_[at_], now);
    if (goes_on_moving) {
        steps_[at_] = now;
        return;
    }
    if (steps_.size() == most_steps) {
        steps_.erase(steps_.begin());
    }
    steps_.push_back(now);
    at_ = steps_.size() - 1;
}

const Document &History::undo() {
    at_ -= can_undo() ? 1 : 0;
    return current();
}

const Document &History::redo() {
    at_ += can_redo() ? 1 : 0;
    return current();
}

} // namespace sandbox

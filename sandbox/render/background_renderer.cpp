#include "render/background_renderer.h"

#include "image/error.h"

#include <algorithm>
#include <utility>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace sandbox {

BackgroundRenderer::BackgroundRenderer(const Context &window, Assets assets, Assets shaders)
    : window_(window), assets_(std::move(assets)), shaders_(std::move(shaders)),
      own_(own_server_command(assets_, shaders_, current_profile())) {}

BackgroundRenderer::~BackgroundRenderer() {
    try {
        if (renderer_) {
            const WorkerContext::Current current(*context_);
            renderer_.reset();
        }
        window_.make_current();
    } catch (const MachineError &) {
        return; // the driver is gone, and with it what lived there
    }
}

void BackgroundRenderer::make_context() {
    if (!context_) {
        context_ = window_.make_worker();
    }
}

std::size_t BackgroundRenderer::waiting() const {
    const std::lock_guard lock(mutex_);
    return turns_.empty() ? 0 : turns_.size() - 1;
}

/// False if `stop` comes first.
bool BackgroundRenderer::wait_for(const Turn &turn, const std::stop_token &stop) {
    std::unique_lock lock(mutex_);
    turns_.push_back(&turn);
    const bool begun = turn_ended_.wait(lock, stop, [&] { return turns_.front() == &turn; });
    if (!begun) {
        std::erase(turns_, &turn);
    }
    return begun;
}

void BackgroundRenderer::end_turn() {
    {
        const std::lock_guard lock(mutex_);
        turns_.pop_front();
    }
    turn_ended_.notify();
}

BackgroundRenderer::Turn::Turn(BackgroundRenderer &shared, const std::stop_token &stop, Broken broken)
    : shared_(shared) {
    if (!shared_.wait_for(*this, stop)) {
        return;
    }
    try {
        current_.emplace(*shared_.context_);
        if (!shared_.renderer_) {
            shared_.renderer_ = std::make_unique<Renderer>(shared_.assets_, ShaderParts(shared_.shaders_));
            shared_.renderer_->draw_own_by(drawn_by(shared_.own_));
        }
        if (shared_.begun_ == 0) { // a job that lets others draw goes on with the parts that it began with
            shared_.renderer_->reload_changed_parts();
        }
        if (broken == Broken::fails) {
            shared_.renderer_->forget_last_good_programs();
        }
        ++shared_.begun_;
        begun_ = true;
    } catch (...) {
        current_.reset();
        shared_.end_turn();
        throw;
    }
}

BackgroundRenderer::Turn::~Turn() {
    if (!begun_) {
        return;
    }
    --shared_.begun_;
    current_.reset();
#ifdef __GLIBC__
    malloc_trim(0); // a job leaves pages free all over the heaps
#endif
    shared_.end_turn();
}

void BackgroundRenderer::Turn::let_others_draw() {
    let_others_run();
    if (shared_.waiting() == 0) {
        return;
    }
    current_.reset();
    shared_.end_turn();
    shared_.wait_for(*this, {}); // even if the job is cancelled: what it has made has to be deleted here
    current_.emplace(*shared_.context_);
}

} // namespace sandbox

#include "image/page_thread.h"

#include "image/thread.h"

#include <chrono>
#include <emscripten/stack.h>
#include <utility>
#include <vector>

extern "C" {
// sandbox/page/threads.js
int page_can_suspend();
void page_suspend();
int page_context();
void page_use_context(int context);
void page_start(void (*run)(void *), void *argument, void *stack);
// Of Emscripten's runtime: sets WebAssembly's stack pointer.
void _emscripten_stack_restore(void *top);
}

namespace sandbox {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds slice{8};
constexpr std::size_t stack_bytes = std::size_t{1} << 20;

/// When whoever runs now began to.
Clock::time_point &slice_begin() {
    static Clock::time_point begin = Clock::now();
    return begin;
}

} // namespace

bool can_suspend() { return page_can_suspend() != 0; }

/// Whoever ran meanwhile has left the stack pointer on a stack of its own, and another
/// context current.
void suspend() {
    void *const stack = reinterpret_cast<void *>(emscripten_stack_get_current());
    const int context = page_context();
    page_suspend();
    _emscripten_stack_restore(stack);
    page_use_context(context);
    slice_begin() = Clock::now();
}

struct Thread::State {
    std::function<void(const std::stop_token &)> work;
    std::stop_source stop;
    bool begun = false, ended = false;
    std::vector<std::byte> stack = std::vector<std::byte>(stack_bytes);

    void run() {
        if (!std::exchange(begun, true)) {
            slice_begin() = Clock::now();
            work(stop.get_token());
            work = nullptr; // what it holds ends here, as a thread's does
            ended = true;
        }
    }
};

Thread::Thread(std::function<void(const std::stop_token &)> work) : state_(std::make_shared<State>()) {
    state_->work = std::move(work);
    const auto run = [](void *kept) {
        const std::unique_ptr<std::shared_ptr<State>> state(static_cast<std::shared_ptr<State> *>(kept));
        (*state)->run();
    };
    page_start(run, new std::shared_ptr<State>(state_), stack_top(state_->stack));
}

Thread::Thread(Thread &&) noexcept = default;

Thread &Thread::operator=(Thread &&other) noexcept {
    std::swap(state_, other.state_);
    return *this;
}

Thread::~Thread() {
    if (state_) {
        request_stop();
        join();
    }
}

void Thread::request_stop() {
    if (state_) {
        state_->stop.request_stop();
    }
}

std::stop_token Thread::get_stop_token() const { return state_ ? state_->stop.get_token() : std::stop_token(); }

void Thread::join() {
    if (state_ && !can_suspend()) {
        state_->run();
    }
    while (state_ && !state_->ended) {
        suspend();
    }
    state_.reset();
}

void suspend_if_due() {
    if (can_suspend() && Clock::now() - slice_begin() >= slice) {
        suspend();
    }
}

bool Signal::wait(std::unique_lock<std::mutex> &lock, const std::stop_token &stop, const std::function<bool()> &holds) {
    while (!holds()) {
        if (stop.stop_requested()) {
            return false;
        }
        lock.unlock();
        suspend();
        lock.lock();
    }
    return true;
}

void *stack_top(std::vector<std::byte> &stack) {
    constexpr std::uintptr_t aligned = 16;
    return reinterpret_cast<void *>((reinterpret_cast<std::uintptr_t>(stack.data()) + stack.size()) & ~(aligned - 1));
}

} // namespace sandbox

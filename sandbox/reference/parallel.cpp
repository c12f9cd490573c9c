#include "reference/parallel.h"

#include "image/thread.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace sandbox {

namespace {

/// One call of parallel_for: hands out the indices and keeps the first failure.
class Loop {
  public:
    Loop(std::size_t count, const std::function<void(std::size_t)> &work, const Progress &progress)
        : count_(count), work_(work), progress_(progress) {}

    [[nodiscard]] bool has_work() const { return next_ < count_ && !stopped_; }

    void run() {
        for (std::size_t i = next_++; i < count_ && !stopped_; i = next_++) {
            try {
                work_(i);
                report();
                let_others_run();
            } catch (...) {
                fail(std::current_exception());
            }
        }
    }

    void rethrow() const {
        if (failure_) {
            std::rethrow_exception(failure_);
        }
    }

    int helpers = 0; ///< threads of the pool inside run(); guarded by the pool's mutex

  private:
    void report() {
        const std::lock_guard lock(mutex_);
        ++done_;
        if (progress_ && !stopped_ && !progress_(static_cast<double>(done_) / static_cast<double>(count_))) {
            throw Cancelled();
        }
    }

    void fail(std::exception_ptr failure) {
        const std::lock_guard lock(mutex_);
        if (!failure_) {
            failure_ = std::move(failure);
        }
        stopped_ = true;
    }

    std::size_t count_;
    const std::function<void(std::size_t)> &work_;
    const Progress &progress_;
    std::atomic<std::size_t> next_{0};
    std::atomic<bool> stopped_{false};
    std::size_t done_ = 0;
    std::exception_ptr failure_;
    std::mutex mutex_;
};

/// Threads that help with every loop there is, as long as the program runs. A thread that calls parallel_for works on
/// its own loop until no index is left, so loops within loops and loops of several threads never wait for a free
/// helper.
class Pool {
  public:
    Pool() {
        for (unsigned i = 1; i < std::thread::hardware_concurrency(); ++i) {
            helpers_.emplace_back([this](const std::stop_token &stop) { help(stop); });
        }
    }

    void run(Loop &loop) {
        std::unique_lock lock(mutex_);
        loops_.push_back(&loop);
        lock.unlock();
        loop_added_.notify_all();
        loop.run();
        lock.lock();
        std::erase(loops_, &loop);
        helper_left_.wait(lock, [&] { return loop.helpers == 0; });
    }

  private:
    void help(const std::stop_token &stop) {
        std::unique_lock lock(mutex_);
        auto found = loops_.end();
        const auto find = [&] {
            found = std::ranges::find_if(loops_, &Loop::has_work);
            return found != loops_.end();
        };
        while (loop_added_.wait(lock, stop, find)) {
            Loop &loop = **found;
            ++loop.helpers;
            lock.unlock();
            loop.run();
            lock.lock();
            --loop.helpers;
            helper_left_.notify_all();
        }
    }

    std::mutex mutex_;
    std::condition_variable_any loop_added_, helper_left_;
    std::vector<Loop *> loops_;
    std::vector<std::jthread> helpers_; ///< last: they end before what they use
};

} // namespace

void parallel_for(std::size_t count, const std::function<void(std::size_t)> &work, const Progress &progress) {
    static Pool pool;
    Loop loop(count, work, progress);
    pool.run(loop);
    loop.rethrow();
}

} // namespace sandbox

#include "reference/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace sandbox {

namespace {

/// Hands out the indices and keeps the first failure.
class Queue {
  public:
    Queue(std::size_t count, const Progress &progress) : count_(count), progress_(progress) {}

    void run(const std::function<void(std::size_t)> &work) {
        for (std::size_t i = next_++; i < count_ && !stopped_; i = next_++) {
            try {
                work(i);
                report();
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
    const Progress &progress_;
    std::atomic<std::size_t> next_{0};
    std::atomic<bool> stopped_{false};
    std::size_t done_ = 0;
    std::exception_ptr failure_;
    std::mutex mutex_;
};

} // namespace

void parallel_for(std::size_t count, const std::function<void(std::size_t)> &work, const Progress &progress) {
    Queue queue(count, progress);
    const std::size_t cores = std::max<std::size_t>(1, std::thread::hardware_concurrency());
    {
        std::vector<std::jthread> helpers;
        for (std::size_t i = 1; i < std::min(cores, count); ++i) {
            helpers.emplace_back([&] { queue.run(work); });
        }
        queue.run(work);
    }
    queue.rethrow();
}

} // namespace sandbox

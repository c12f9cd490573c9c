#pragma once

#include "image/thread.h"

#include <chrono>
#include <functional>
#include <mutex>
#include <stop_token>
#include <string>

/// Work in the background: a thread that reports its progress, can be stopped, and returns its errors as text.
namespace sandbox {

struct JobProgress {
    double share = 0;  ///< [0, 1]
    std::string doing; ///< one line: what the job is doing
};

enum class JobState { running, done, failed };
enum class News { none, progress, result }; ///< the more important, the greater

/// The work's side of a job; usable from every thread that the work starts.
class JobReporter {
  public:
    /// False once the job has been cancelled; the work should then end soon.
    bool report(double share);
    [[nodiscard]] bool cancelled() const { return stop_.stop_requested(); }
    [[nodiscard]] const std::stop_token &stop_token() const { return stop_; }
    /// There is something new to show, now.
    void wake();
    void say(std::string doing);

  private:
    friend class BackgroundJob;
    using Clock = std::chrono::steady_clock;
    static constexpr std::chrono::milliseconds between_news{250};

    void end(JobState state, std::string error);

    mutable std::mutex mutex_; ///< guards all below but the stop token
    JobProgress progress_;
    JobState state_ = JobState::running;
    std::string error_;
    bool news_ = false;
    Clock::time_point last_news_ = Clock::now();
    std::stop_token stop_;
    std::function<void()> wake_;
};

class BackgroundJob {
  public:
    using Work = std::function<void(JobReporter &)>;

    /// Starts at once. `wake` is called from the job's threads when there is news: at most four times a second, and
    /// once at the end.
    BackgroundJob(Work work, std::function<void()> wake);
    /// Stops the work and waits for it.
    ~BackgroundJob() = default;
    BackgroundJob(const BackgroundJob &) = delete;
    BackgroundJob &operator=(const BackgroundJob &) = delete;

    void cancel() { thread_.request_stop(); }
    /// Waits until it has ended by itself.
    void wait() { thread_.join(); }
    [[nodiscard]] bool cancelled() const { return thread_.get_stop_token().stop_requested(); }
    /// The result may be read once this is no longer `running`.
    [[nodiscard]] JobState state() const;
    [[nodiscard]] JobProgress progress() const;
    /// Why the job failed.
    [[nodiscard]] std::string error() const;
    /// What is new since the last call; `result`: it has ended.
    News take_news();

  private:
    JobReporter reporter_;
    Thread thread_; ///< last: ends before what it reports to
};

} // namespace sandbox

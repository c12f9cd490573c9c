#pragma once

#include <chrono>
#include <functional>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>

/// Work beside the window: a thread that says how far it is, can be stopped, and brings its errors back as text.
namespace sandbox {

/// How far a job is.
struct JobProgress {
    double share = 0;  ///< [0, 1]
    std::string doing; ///< one line: what it is at
};

enum class JobState { running, done, failed };
enum class News { none, progress, result }; ///< from little to much

/// The work's side of a job; usable from every thread that the work starts.
class JobReporter {
  public:
    /// Returns false once the job is to stop: the work then ends soon, in whatever way suits it.
    bool report(double share);
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
    [[nodiscard]] bool cancelled() const { return thread_.get_stop_token().stop_requested(); }
    /// What the work wrote may be read once this is no longer `running`.
    [[nodiscard]] JobState state() const;
    [[nodiscard]] JobProgress progress() const;
    /// Why it failed.
    [[nodiscard]] std::string error() const;
    /// What is new since the last call; `result`: it has ended.
    News take_news();

  private:
    JobReporter reporter_;
    std::jthread thread_; ///< last: ends before what it reports to
};

} // namespace sandbox

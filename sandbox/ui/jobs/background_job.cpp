#include "ui/jobs/background_job.h"

#include <algorithm>
#include <exception>
#include <utility>

namespace sandbox {

bool JobReporter::report(double share) {
    bool wake = false;
    {
        const std::lock_guard lock(mutex_);
        progress_.share = std::clamp(share, 0.0, 1.0);
        const Clock::time_point now = Clock::now();
        if (now - last_news_ >= between_news) {
            last_news_ = now;
            wake = news_ = true;
        }
    }
    if (wake) {
        wake_();
    }
    let_others_run();
    return !stop_.stop_requested();
}

void JobReporter::wake() {
    {
        const std::lock_guard lock(mutex_);
        last_news_ = Clock::now();
        news_ = true;
    }
    wake_();
}

void JobReporter::say(std::string doing) {
    const std::lock_guard lock(mutex_);
    progress_.doing = std::move(doing);
}

void JobReporter::end(JobState state, std::string error) {
    {
        const std::lock_guard lock(mutex_);
        state_ = state;
        error_ = std::move(error);
        news_ = true;
    }
    wake_();
}

BackgroundJob::BackgroundJob(Work work, std::function<void()> wake) {
    reporter_.wake_ = std::move(wake);
    thread_ = Thread([this, work = std::move(work)](const std::stop_token &stop) {
        reporter_.stop_ = stop;
        try {
            work(reporter_);
            reporter_.end(JobState::done, {});
        } catch (const std::exception &error) {
            reporter_.end(JobState::failed, error.what());
        }
    });
}

JobState BackgroundJob::state() const {
    const std::lock_guard lock(reporter_.mutex_);
    return reporter_.state_;
}

JobProgress BackgroundJob::progress() const {
    const std::lock_guard lock(reporter_.mutex_);
    return reporter_.progress_;
}

std::string BackgroundJob::error() const {
    const std::lock_guard lock(reporter_.mutex_);
    return reporter_.error_;
}

News BackgroundJob::take_news() {
    const std::lock_guard lock(reporter_.mutex_);
    const bool news = std::exchange(reporter_.news_, false);
    return !news ? News::none : reporter_.state_ == JobState::running ? News::progress : News::result;
}

} // namespace sandbox

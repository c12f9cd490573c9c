#pragma once

#include <chrono>
#include <string>

namespace sandbox {

/// How far long work is, on standard error: a bar on a terminal, a line every few seconds otherwise. Work that is over
/// within a second says nothing. Not thread-safe.
class ProgressBar {
  public:
    explicit ProgressBar(std::string what);
    ~ProgressBar();
    ProgressBar(const ProgressBar &) = delete;
    ProgressBar &operator=(const ProgressBar &) = delete;

    /// `share` from 0 to 1.
    void report(double share);

  private:
    using Clock = std::chrono::steady_clock;
    std::string what_;
    bool terminal_;
    bool shown_ = false;
    Clock::time_point next_;
};

} // namespace sandbox

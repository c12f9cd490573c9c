#pragma once

#include <chrono>
#include <string>

namespace sandbox {

/// Progress of long work on standard error: a bar on a terminal, otherwise a line every few seconds. Work that takes
/// less than a second shows nothing. Not thread-safe.
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

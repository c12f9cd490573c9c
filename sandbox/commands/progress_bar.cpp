#include "commands/progress_bar.h"

#include "image/thread.h"

#include <algorithm>
#include <cstdio>
#include <fmt/format.h>
#include <unistd.h>

namespace sandbox {
namespace {

using namespace std::chrono_literals;
constexpr std::size_t bar_cells = 40;

} // namespace

ProgressBar::ProgressBar(std::string what)
    : what_(std::move(what)), terminal_(isatty(STDERR_FILENO) != 0), next_(Clock::now() + 1s) {}

ProgressBar::~ProgressBar() {
    if (terminal_ && shown_) {
        std::fputs("\r\x1b[K", stderr); // the bar leaves nothing behind
    }
}

void ProgressBar::report(double share) {
    let_others_run();
    if (Clock::now() < next_ || (share >= 1 && !shown_)) {
        return;
    }
    const auto percent = static_cast<std::size_t>(100 * std::clamp(share, 0.0, 1.0));
    if (terminal_) {
        fmt::print(stderr, "\r{} [{:<{}}] {:3} %", what_, std::string(bar_cells * percent / 100, '#'), bar_cells,
                   percent);
    } else {
        fmt::print(stderr, "{}: {} %\n", what_, percent);
    }
    shown_ = true;
    next_ = Clock::now() + (terminal_ ? 100ms : 2000ms);
}

} // namespace sandbox

#include "commands/interrupt.h"

#include "image/image_file.h"

#include <atomic>
#include <csignal>
#include <unistd.h>

namespace sandbox {
namespace {

// A signal may arrive on any thread while another writes, so who comes first is decided by one atomic step.
enum class State { free, writing, ending, ending_after_write };
std::atomic<State> state{State::free};
static_assert(std::atomic<State>::is_always_lock_free, "a signal handler may touch nothing else");

constexpr int interrupted = 130;

void end_or_wait(int) {
    State expected = State::free;
    if (state.compare_exchange_strong(expected, State::ending)) {
        _exit(interrupted);
    }
    expected = State::writing;
    state.compare_exchange_strong(expected, State::ending_after_write);
}

/// While it lives an interrupt waits.
class WriteGuard {
  public:
    WriteGuard() {
        State expected = State::free;
        while (!state.compare_exchange_strong(expected, State::writing)) {
            pause(); // the process is about to end
            expected = State::free;
        }
    }
    ~WriteGuard() {
        State expected = State::writing;
        if (!state.compare_exchange_strong(expected, State::free)) {
            _exit(interrupted);
        }
    }
    WriteGuard(const WriteGuard &) = delete;
    WriteGuard &operator=(const WriteGuard &) = delete;
};

} // namespace

void handle_interrupts() {
    struct sigaction action {};
    action.sa_handler = end_or_wait;
    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
    std::signal(SIGPIPE, SIG_IGN);
}

void write_output(const std::filesystem::path &path, std::string_view bytes) {
    const WriteGuard guard;
    write_file(path, bytes);
}

} // namespace sandbox

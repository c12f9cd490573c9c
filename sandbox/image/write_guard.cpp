#include "image/write_guard.h"

#include <atomic>
#include <unistd.h>

namespace sandbox {
namespace {

// A signal may arrive on any thread while others write, so who comes first is decided by one atomic step.
constexpr unsigned ending = 1U << 31;
std::atomic<unsigned> state{0}; ///< how many write; `ending`: the last of them ends the process
std::atomic<int> exit_code{0};
static_assert(std::atomic<unsigned>::is_always_lock_free && std::atomic<int>::is_always_lock_free,
              "a signal handler may touch nothing else");

} // namespace

WriteGuard::WriteGuard() {
    unsigned seen = state;
    do {
        while ((seen & ending) != 0) {
            pause(); // the process is about to end
            seen = state;
        }
    } while (!state.compare_exchange_weak(seen, seen + 1));
}

WriteGuard::~WriteGuard() {
    if (state.fetch_sub(1) == (ending | 1U)) {
        _exit(exit_code);
    }
}

void end_between_writes(int code) {
    exit_code = code;
    if ((state.fetch_or(ending) & ~ending) == 0) {
        _exit(code);
    }
}

} // namespace sandbox

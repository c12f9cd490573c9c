#include "render/socket.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace sandbox {
namespace {

/// False where the deadline comes first.
bool wait_for(int descriptor, short events, double deadline) {
    for (;;) {
        const double left = deadline - monotonic_seconds();
        if (left <= 0) {
            return false;
        }
        constexpr double longest_wait = 3600;
        pollfd asked{descriptor, events, 0};
        const int ready = poll(&asked, 1, static_cast<int>(std::min(left, longest_wait) * 1000) + 1);
        if (ready > 0) {
            return true;
        }
        if (ready < 0 && errno != EINTR) {
            return false;
        }
    }
}

/// Calls `some` with what is done and what is left until all is done; it says how many bytes went, as send() does.
template <typename Some> bool all(int descriptor, short events, std::size_t count, double deadline, Some some) {
    std::size_t done = 0;
    while (done < count) {
        if (!wait_for(descriptor, events, deadline)) {
            return false;
        }
        const ssize_t went = some(done, count - done);
        if (went > 0) {
            done += static_cast<std::size_t>(went);
        } else if (went == 0 || (errno != EINTR && errno != EAGAIN)) {
            return false;
        }
    }
    return true;
}

} // namespace

double monotonic_seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

Socket::~Socket() { close(descriptor_); }

bool Socket::send(const void *bytes, std::size_t count, double deadline) const {
    const auto *from = static_cast<const char *>(bytes);
    return all(descriptor_, POLLOUT, count, deadline, [&](std::size_t done, std::size_t left) {
        return ::send(descriptor_, from + done, left, MSG_NOSIGNAL | MSG_DONTWAIT);
    });
}

bool Socket::receive(void *bytes, std::size_t count, double deadline) const {
    auto *into = static_cast<char *>(bytes);
    return all(descriptor_, POLLIN, count, deadline,
               [&](std::size_t done, std::size_t left) { return recv(descriptor_, into + done, left, MSG_DONTWAIT); });
}

} // namespace sandbox

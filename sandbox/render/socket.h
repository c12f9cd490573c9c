#pragma once

#include <cstddef>

namespace sandbox {

/// CLOCK_MONOTONIC: what deadlines are told in.
double monotonic_seconds();
constexpr double no_deadline = 1e18;

/// One end of a connection between two processes; closed with this.
class Socket {
  public:
    explicit Socket(int descriptor) : descriptor_(descriptor) {}
    ~Socket();
    Socket(const Socket &) = delete;
    Socket &operator=(const Socket &) = delete;

    /// All bytes. False where the other end is closed or the deadline comes first.
    [[nodiscard]] bool send(const void *bytes, std::size_t count, double deadline) const;
    [[nodiscard]] bool receive(void *bytes, std::size_t count, double deadline) const;
    [[nodiscard]] int descriptor() const { return descriptor_; }

  private:
    int descriptor_;
};

} // namespace sandbox

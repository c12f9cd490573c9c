#pragma once

#include "render/socket.h"

#include <memory>
#include <string>
#include <sys/types.h>
#include <vector>

namespace sandbox {

/// A process whose standard input is the other end of a socket; what it prints goes nowhere. Killed with this.
class ChildProcess {
  public:
    /// `command`: a program's path and its arguments. Throws MachineError where it cannot be started.
    explicit ChildProcess(const std::vector<std::string> &command);
    ~ChildProcess() { end(); }
    ChildProcess(const ChildProcess &) = delete;
    ChildProcess &operator=(const ChildProcess &) = delete;

    [[nodiscard]] const Socket &socket() const { return *socket_; }

    struct End {
        int signal = 0; ///< that ended it; 0: it exited
        double processor_seconds = 0;
    };
    /// Gives it `seconds` to end by itself, then kills it.
    End end(double seconds = 0);

  private:
    [[nodiscard]] bool has_ended() const;

    std::unique_ptr<Socket> socket_;
    pid_t process_ = 0; ///< 0: none any more
    End end_;
};

} // namespace sandbox

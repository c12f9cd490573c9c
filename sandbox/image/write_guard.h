#pragma once

namespace sandbox {

/// While one lives, an interrupt waits: no half-written file is left. Any number of threads may hold one, but no thread
/// two.
class WriteGuard {
  public:
    WriteGuard();
    ~WriteGuard();
    WriteGuard(const WriteGuard &) = delete;
    WriteGuard &operator=(const WriteGuard &) = delete;
};

/// What a shell says of a program that Ctrl-C ended.
constexpr int interrupted_exit = 130;

/// Ends the process with that code: at once, or, after it has returned, when the last write is done. A signal's handler
/// may call it.
void end_between_writes(int code = interrupted_exit);

} // namespace sandbox

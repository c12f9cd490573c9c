#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>
#ifdef __EMSCRIPTEN__
#include <memory>
#endif

/// Threads and how they wait. A page has one thread: there ours are turns of it, each on a stack of its own, that go on
/// where they stopped; in a browser that cannot stop in the middle of a function (no JSPI) each runs in one go.
namespace sandbox {

#ifndef __EMSCRIPTEN__

using Thread = std::jthread;

/// What one thread tells others that wait.
class Signal {
  public:
    void notify() { signal_.notify_all(); }
    /// True once `holds`; false if `stop` comes first. `lock` is held whenever that is asked, and afterwards.
    bool wait(std::unique_lock<std::mutex> &lock, const std::stop_token &stop, const std::function<bool()> &holds) {
        return signal_.wait(lock, stop, holds);
    }

  private:
    std::condition_variable_any signal_;
};

#else

class Thread {
  public:
    Thread() = default;
    explicit Thread(std::function<void(const std::stop_token &)> work);
    Thread(Thread &&) noexcept;
    Thread &operator=(Thread &&) noexcept;
    /// As std::jthread: stops the work and waits for it.
    ~Thread();

    void request_stop();
    [[nodiscard]] std::stop_token get_stop_token() const;
    void join();

    struct State;

  private:
    std::shared_ptr<State> state_;
};

class Signal {
  public:
    void notify() {}
    bool wait(std::unique_lock<std::mutex> &lock, const std::stop_token &stop, const std::function<bool()> &holds);
};

#endif

/// Work that takes long calls this often: all else in a page gets its turn.
void let_others_run();
/// For what waits for others without a signal.
void rest();

} // namespace sandbox

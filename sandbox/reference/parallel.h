#pragma once

#include <cstddef>
#include <functional>
#include <stdexcept>

namespace sandbox {

/// Receives the share done, in [0, 1], and returns false to stop the work. Called from worker threads, one at a time.
using Progress = std::function<bool(double share)>;

/// Thrown by work that its Progress stopped.
struct Cancelled : std::runtime_error {
    Cancelled() : std::runtime_error("cancelled") {}
};

/// Calls work(i) for i in [0, count) on all cores, in any order: each i must own what it writes, so that the result
/// does not depend on the number of cores. The first exception of `work` is thrown again here; Cancelled if progress
/// says stop. Any thread may call it at any time, also from within `work`: all calls share one set of threads, which
/// start with the first call and end with the program.
void parallel_for(std::size_t count, const std::function<void(std::size_t)> &work, const Progress &progress = {});

} // namespace sandbox

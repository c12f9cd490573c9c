#pragma once

#include <cstddef>
#include <functional>
#include <stdexcept>

namespace sandbox {

/// Told the share done, in [0, 1]; returns false to stop the work. Called from worker threads, one at a time.
using Progress = std::function<bool(double share)>;

/// Thrown out of work whose Progress said stop.
struct Cancelled : std::runtime_error {
    Cancelled() : std::runtime_error("cancelled") {}
};

/// Calls work(i) for i in [0, count) on all cores. The order is free, so each i must own what it writes; the result
/// then does not depend on the number of cores. The first exception of `work` is thrown again here; Cancelled if
/// progress says stop. Any thread may call it at any time, also from within `work`: all calls share one set of threads,
/// which start with the first call and end with the program.
void parallel_for(std::size_t count, const std::function<void(std::size_t)> &work, const Progress &progress = {});

} // namespace sandbox

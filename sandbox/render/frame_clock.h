#pragma once

#include "render/gl_object.h"
#include "render/target.h"

#include <functional>
#include <optional>
#include <string_view>

namespace sandbox {

/// What FrameClock::name() may be.
inline constexpr std::string_view gpu_clock = "GPU timer (GL_TIME_ELAPSED), which agreed with the wall clock on a long "
                                              "draw",
                                  wall_clock = "wall clock around draw and glFinish";

/// Times finished frames by the clock that can be trusted here: the GPU's own timer (GL_TIME_ELAPSED) where a long draw
/// has shown that it agrees with the wall clock; else the wall clock around draw and glFinish. Software renderers keep
/// to the wall clock: they put work off until after the timer has stopped.
class FrameClock {
  public:
    /// Frames are drawn into `target`, which must outlive this. Draws `frame` again and again, for some 50 ms, unless
    /// the renderer is `software` (Context::software).
    FrameClock(bool software, const Target &target, const std::function<void()> &frame);

    /// Draws `frame` once and waits until it is done; milliseconds.
    double milliseconds(const std::function<void()> &frame);
    /// What every result should say of its times.
    [[nodiscard]] std::string_view name() const;

  private:
    const Target &target_;
    std::optional<Query> timer_; ///< none: the wall clock
};

/// Of one long draw: a timer that misses a fifth of it, or sees more than there was, counts something else.
bool clocks_agree(double gpu_milliseconds, double wall_milliseconds);

} // namespace sandbox

#pragma once

#include "image/image.h"

#include <string_view>

namespace sandbox {

enum class DepthTest { on, off };

/// The OpenGL state of one pass into a framebuffer: all of it, no blending, no scissor, no culling. A pass may change
/// blending, depth function and mask, culling, winding, depth clamp, polygon mode and offset. At the end of the scope
/// all of these are OpenGL's defaults again, also when something throws; nothing is asked of the driver, which would
/// wait for it.
class PassState {
  public:
    /// `framebuffer` 0 is the window's own.
    PassState(unsigned framebuffer, Size size, DepthTest depth_test);
    ~PassState();
    PassState(const PassState &) = delete;
    PassState &operator=(const PassState &) = delete;
};

/// Throws MachineError "OpenGL cannot `action`: out of memory" if OpenGL has reported an error since it was last asked.
/// Waits for the driver: for what is made and uploaded, not for every draw.
void check_gl(std::string_view action);

} // namespace sandbox

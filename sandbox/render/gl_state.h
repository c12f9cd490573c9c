#pragma once

#include "image/image.h"

#include <string_view>

namespace sandbox {

enum class DepthTest { on, off };

/// The OpenGL state of one pass into a framebuffer: all of it, no blending, no scissor, no culling. A pass may change
/// blending, depth function and mask, culling and winding. At the end of the scope all of these are OpenGL's defaults
/// again, also when something throws; nothing is asked of the driver, which would
/// wait for it.
class PassState {
  public:
    /// `framebuffer` 0 is the window's own.
    PassState(unsigned framebuffer, Size size, DepthTest depth_test);
    ~PassState();
    PassState(const PassState &) = delete;
    PassState &operator=(const PassState &) = delete;
};

/// Whether the current context is OpenGL ES.
bool is_es();
/// Before the driver is asked something: in a page all else has its turns until it can answer at once.
void let_driver_catch_up();
/// Waits until all that was drawn into `framebuffer` is done. `type`: of its colours, GL_FLOAT or GL_UNSIGNED_BYTE.
void finish_drawing(unsigned framebuffer, unsigned type);
/// Likewise for what nobody times: all else in a page has its turns meanwhile.
void finish_drawing_in_turns(unsigned framebuffer, unsigned type);
/// What OpenGL has reported up to here is nobody's fault.
void forget_gl_errors();
bool has_gl_extension(std::string_view name);

/// Throws MachineError "OpenGL cannot `action`: out of memory" if OpenGL has reported an error since it was last asked.
/// Waits for the driver: for what is made and uploaded, not for every draw.
void check_gl(std::string_view action);

} // namespace sandbox

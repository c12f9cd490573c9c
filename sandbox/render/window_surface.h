#pragma once

#include "image/image.h"

namespace sandbox {

/// Binds the window's own framebuffer, all of it, and clears it to black: before a frame is drawn into it.
void begin_window_surface(Size framebuffer);

} // namespace sandbox

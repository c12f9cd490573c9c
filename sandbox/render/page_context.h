#pragma once

#include "render/context.h"

namespace sandbox {

/// WebGL 2 of the page's canvas: what the window is drawn on. Throws MachineError, which says what to try.
std::unique_ptr<Context> make_canvas_context();

} // namespace sandbox

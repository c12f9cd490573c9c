#pragma once

#include "render/context.h"

namespace sandbox {

/// OpenGL through EGL, without a surface: on the surfaceless platform, else on a device, else on the default display.
/// Throws MachineError.
std::unique_ptr<Context> make_egl_context();

} // namespace sandbox

#pragma once

#include "render/context.h"

namespace sandbox {

/// OpenGL of a profile through EGL, without a surface: on the surfaceless platform, else on a device, else on the
/// default display. Throws MachineError.
std::unique_ptr<Context> make_egl_context(Profile profile);

/// A context of the current one's profile, of the software renderer called `renderer` on a display that is not the
/// current one, so that it shares nothing with it: llvmpipe looks through the frames of all contexts of a display
/// without a lock. None: there is no such display. Afterwards no context is current.
std::unique_ptr<WorkerContext> make_software_worker(const std::string &renderer);

} // namespace sandbox

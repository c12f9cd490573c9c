#include "render/context.h"
#include "render/egl_context.h"
#include "render/glfw_context.h"

namespace sandbox {

std::unique_ptr<Context> Context::headless(Backend backend, Profile profile) {
    return backend == Backend::egl ? make_egl_context(profile) : make_hidden_window_context(profile);
}

} // namespace sandbox

#pragma once

#include "render/context.h"

namespace sandbox {

std::unique_ptr<Context> make_egl_context();
std::unique_ptr<Context> make_hidden_glfw_context();

constexpr const char *install_hint =
    "install a driver, or Mesa's software one (Debian and Ubuntu: apt install libegl1 libgl1-mesa-dri)";

} // namespace sandbox

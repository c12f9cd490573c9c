#pragma once

#include "render/context.h"

#include <string>

struct GLFWwindow;

namespace sandbox {

/// OpenGL in a hidden window, for `--backend glfw`. Throws MachineError.
std::unique_ptr<Context> make_hidden_window_context(Profile profile);
/// What the next window of GLFW is made with.
void set_context_hints(Profile profile);
/// OpenGL in a window that somebody else owns and made with these hints; its context becomes current. Throws
/// MachineError.
std::unique_ptr<Context> make_window_context(GLFWwindow *window, Profile profile);

/// What GLFW says of the last thing that went wrong; "no reason given" if it says nothing.
std::string glfw_error();

} // namespace sandbox

#pragma once

namespace sandbox {

/// From here on, after glfwInit(): an X server that goes away ends the process with exit code 3 and a sentence; Xlib
/// would end it with 1, which here says that a check failed. Nothing happens on other displays.
void end_when_display_is_lost();

} // namespace sandbox

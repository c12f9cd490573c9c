#pragma once

#include <functional>

namespace sandbox {

/// Tells Dear ImGui what GLFW calls the keys that its widgets use: of a host that is not GLFW's window.
void name_gui_keys();
/// Which of them are down in the frame that begins; `is_down` is asked by GLFW's names.
void press_gui_keys(const std::function<bool(int key)> &is_down);

} // namespace sandbox

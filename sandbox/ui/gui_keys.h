#pragma once

#include "ui/keyboard.h"

namespace sandbox {

/// Tells Dear ImGui what is down in the frame that begins.
void press_gui_keys(const KeysDown &down);

} // namespace sandbox

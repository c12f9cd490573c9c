#pragma once

#include "ui/session/session.h"

namespace sandbox {

/// Runs the action of a key, if it has one. `key` and `mods` as GLFW names them, `key` after the keyboard's layout;
/// `typing`: a text field has the keyboard, so that only Ctrl+Q and the function keys count.
void press_key(Session &session, int key, int mods, bool repeated, bool typing);

/// The window that lists keys and mouse, while it is open.
void key_list(Session &session);

} // namespace sandbox

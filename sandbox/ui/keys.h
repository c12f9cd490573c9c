#pragma once

#include "ui/session/session.h"

namespace sandbox {

/// Does what the key is for, if anything. `key` and `mods` as GLFW names them, `key` after the keyboard's layout;
/// `typing`: a text field has the keyboard, so that only keys with Ctrl and function keys count.
void press_key(Session &session, int key, int mods, bool repeated, bool typing);

/// GLFW's key for what the keyboard prints there: Ctrl+Z is where Z is.
int layout_key(int key, int scancode);

/// The list of keys, while it is open.
void key_list(Session &session);

} // namespace sandbox

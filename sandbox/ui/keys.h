#pragma once

#include "ui/session/session.h"

namespace sandbox {

/// How the two pictures can be shown: buttons and keys are made from these rows.
struct LayoutChoice {
    Layout layout;
    char key;
    const char *name, *help;
};
constexpr LayoutChoice layout_choices[] = {
    {Layout::side_by_side, '1', "side by side", "A and B beside each other"},
    {Layout::wipe, '2', "wipe", "A and B in one picture; drag the divider"},
    {Layout::single, '3', "flip", "A, or B while Space is held"},
    {Layout::difference, '4', "difference", "A - B in colours, with a scale"},
};

/// Runs the shortcut of a key, if it has one. `key` and `mods` as GLFW names them, `key` after the keyboard's layout;
/// `typing`: a text field has the keyboard, so that only Ctrl+Q and the function keys count.
void press_key(Session &session, int key, int mods, bool repeated, bool typing);

/// GLFW's name for what the keyboard prints on a key: Ctrl+Z is where Z is.
int layout_key(int key, int scancode);

/// The window that lists keys and mouse, while it is open.
void key_list(Session &session);

} // namespace sandbox

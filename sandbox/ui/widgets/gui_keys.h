#pragma once

#include <imgui.h>
#include <set>

/// The keyboard of Dear ImGui, whose way to be told of it changed with 1.89: Debian 12 has the old, 13 the new.
namespace sandbox {

/// What is down in a frame: GLFW's names, after the keyboard's layout.
struct KeysDown {
    std::set<int> keys;
    bool ctrl = false, shift = false, alt = false;
};

/// Before the first frame.
void name_gui_keys();
/// What is down in the frame that begins.
void press_gui_keys(const KeysDown &down);
/// Went the key down in this frame, or does it repeat?
bool is_gui_key_pressed(ImGuiKey key);

} // namespace sandbox

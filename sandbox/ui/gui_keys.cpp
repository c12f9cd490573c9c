#include "ui/gui_keys.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

namespace sandbox {
namespace {

/// Dear ImGui's keys that its widgets use, and what GLFW calls them.
struct GuiKey {
    ImGuiKey gui;
    int key;
};
constexpr GuiKey gui_keys[] = {
    {ImGuiKey_LeftArrow, GLFW_KEY_LEFT},
    {ImGuiKey_RightArrow, GLFW_KEY_RIGHT},
    {ImGuiKey_UpArrow, GLFW_KEY_UP},
    {ImGuiKey_DownArrow, GLFW_KEY_DOWN},
    {ImGuiKey_PageUp, GLFW_KEY_PAGE_UP},
    {ImGuiKey_PageDown, GLFW_KEY_PAGE_DOWN},
    {ImGuiKey_Home, GLFW_KEY_HOME},
    {ImGuiKey_End, GLFW_KEY_END},
    {ImGuiKey_Insert, GLFW_KEY_INSERT},
    {ImGuiKey_Delete, GLFW_KEY_DELETE},
    {ImGuiKey_Tab, GLFW_KEY_TAB},
    {ImGuiKey_Space, GLFW_KEY_SPACE},
    {ImGuiKey_Backspace, GLFW_KEY_BACKSPACE},
    {ImGuiKey_Enter, GLFW_KEY_ENTER},
    {ImGuiKey_Escape, GLFW_KEY_ESCAPE},
    {ImGuiKey_A, GLFW_KEY_A},
    {ImGuiKey_C, GLFW_KEY_C},
    {ImGuiKey_V, GLFW_KEY_V},
    {ImGuiKey_X, GLFW_KEY_X},
    {ImGuiKey_Y, GLFW_KEY_Y},
    {ImGuiKey_Z, GLFW_KEY_Z},
};

} // namespace

void press_gui_keys(const KeysDown &down) {
    ImGuiIO &io = ImGui::GetIO();
    const auto has = [&](int mod) { return (down.mods & mod) != 0; };
#if IMGUI_VERSION_NUM >= 18900 // Debian 13; before, keys had numbers of the program's own
    io.AddKeyEvent(ImGuiMod_Ctrl, has(GLFW_MOD_CONTROL));
    io.AddKeyEvent(ImGuiMod_Shift, has(GLFW_MOD_SHIFT));
    io.AddKeyEvent(ImGuiMod_Alt, has(GLFW_MOD_ALT));
    io.AddKeyEvent(ImGuiMod_Super, has(GLFW_MOD_SUPER));
    for (const GuiKey &key : gui_keys) {
        io.AddKeyEvent(key.gui, down.keys.contains(key.key));
    }
#else
    io.KeyCtrl = has(GLFW_MOD_CONTROL);
    io.KeyShift = has(GLFW_MOD_SHIFT);
    io.KeyAlt = has(GLFW_MOD_ALT);
    io.KeySuper = has(GLFW_MOD_SUPER);
    for (const GuiKey &key : gui_keys) {
        io.KeyMap[key.gui] = key.key;
        io.KeysDown[key.key] = down.keys.contains(key.key);
    }
#endif
}

} // namespace sandbox

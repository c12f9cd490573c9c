#include "ui/gui_keys.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

namespace sandbox {

namespace {

/// Dear ImGui's keys that its widgets use, and what GLFW calls them.
struct GuiKey {
    ImGuiKey_ gui;
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

void name_gui_keys() {
    for (const GuiKey &key : gui_keys) {
        ImGui::GetIO().KeyMap[key.gui] = key.key;
    }
}

void press_gui_keys(const std::function<bool(int key)> &is_down) {
    for (const GuiKey &key : gui_keys) {
        ImGui::GetIO().KeysDown[key.key] = is_down(key.key);
    }
}

} // namespace sandbox

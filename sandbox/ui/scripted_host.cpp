#include "ui/scripted_host.h"

#include <GLFW/glfw3.h>
#include <imgui.h>
#include <iterator>

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

ScriptedHost::ScriptedHost(Size size, Profile profile) : context_(Context::headless(Backend::egl, profile)) {
    surface_.emplace(size);
}

void ScriptedHost::begin_gui() {
    ImGuiIO &io = ImGui::GetIO();
    io.BackendPlatformName = "script";
    for (const GuiKey &key : gui_keys) {
        io.KeyMap[key.gui] = key.key;
    }
}

void ScriptedHost::feed_gui() {
    ImGuiIO &io = ImGui::GetIO();
    const Size size = framebuffer_size();
    io.DisplaySize = {static_cast<float>(size.width), static_cast<float>(size.height)};
    io.DisplayFramebufferScale = {1, 1};
    io.DeltaTime = frame_seconds_;
    seconds_ += static_cast<double>(frame_seconds_);
    io.MousePos = {mouse_x_, mouse_y_};
    std::copy(std::begin(buttons_), std::end(buttons_), io.MouseDown);
    io.MouseWheel = std::exchange(wheel_, 0.0F);
    for (const GuiKey &key : gui_keys) {
        io.KeysDown[key.key] = held_.contains(key.key) || pressed_.contains(key.key);
    }
    const auto holds = [&](int key, int mod) {
        return held_.contains(key) || (!pressed_.empty() && (mods_ & mod) != 0);
    };
    io.KeyCtrl = holds(GLFW_KEY_LEFT_CONTROL, GLFW_MOD_CONTROL);
    io.KeyShift = holds(GLFW_KEY_LEFT_SHIFT, GLFW_MOD_SHIFT);
    io.KeyAlt = holds(GLFW_KEY_LEFT_ALT, GLFW_MOD_ALT);
    io.AddInputCharactersUTF8(std::exchange(typed_, {}).c_str());
}

bool ScriptedHost::space_held() const { return held_.contains(GLFW_KEY_SPACE); }

void ScriptedHost::resize(Size size) {
    wake();
    arrivals_.exposed = true;
    surface_.reset();
    surface_.emplace(size);
}

void ScriptedHost::set_content_scale(float scale) {
    wake();
    content_scale_ = scale;
}

ByteImage ScriptedHost::picture() const { return read_window_surface(framebuffer(), framebuffer_size()); }

void ScriptedHost::move_mouse(float x, float y) {
    wake();
    mouse_x_ = x;
    mouse_y_ = y;
}

void ScriptedHost::press(Button button, bool down) {
    wake();
    buttons_[static_cast<int>(button)] = down;
}

void ScriptedHost::turn_wheel(float notches) {
    wake();
    wheel_ += notches;
}

void ScriptedHost::press_key(const KeyChord &chord) {
    wake();
    mods_ = chord.mods;
    pressed_.insert(chord.key);
    arrivals_.keys.push_back({chord.key, chord.mods, false});
    arrivals_.question_mark |= chord.key == GLFW_KEY_SLASH;
}

void ScriptedHost::hold_key(int key, bool down) {
    wake();
    if (down) {
        held_.insert(key);
    } else {
        held_.erase(key);
    }
}

void ScriptedHost::type(const std::string &text) {
    wake();
    typed_ += text;
}

void ScriptedHost::drop(const std::string &path) {
    wake();
    arrivals_.dropped.push_back(path);
}

} // namespace sandbox

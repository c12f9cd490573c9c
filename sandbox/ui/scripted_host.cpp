#include "ui/scripted_host.h"

#include <GLFW/glfw3.h>
#include <algorithm>
#include <imgui.h>
#include <iterator>

namespace sandbox {

ScriptedHost::ScriptedHost(Size size, Profile profile) : context_(Context::headless(Backend::egl, profile)) {
    surface_.emplace(size);
}

void ScriptedHost::begin_gui() {
    ImGuiIO &io = ImGui::GetIO();
    io.BackendPlatformName = "script";
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
    io.AddInputCharactersUTF8(std::exchange(typed_, {}).c_str());
}

KeysDown ScriptedHost::take_keys() {
    KeysDown down{pressed_, pressed_.empty() ? 0 : mods_};
    down.keys.insert(held_.begin(), held_.end());
    for (const auto &[key, mod] :
         {std::pair(GLFW_KEY_LEFT_CONTROL, GLFW_MOD_CONTROL), std::pair(GLFW_KEY_LEFT_SHIFT, GLFW_MOD_SHIFT),
          std::pair(GLFW_KEY_LEFT_ALT, GLFW_MOD_ALT)}) {
        down.mods |= held_.contains(key) ? mod : 0;
    }
    return down;
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
    arrivals_.typed += text;
}

void ScriptedHost::drop(const std::string &path) {
    wake();
    arrivals_.dropped.push_back(path);
}

} // namespace sandbox

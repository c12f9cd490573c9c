#include "ui/page_host.h"

#include "render/page_context.h"

#include <GLFW/glfw3.h>
#include <emscripten.h>
#include <imgui.h>

#include <algorithm>
#include <cfloat>
#include <chrono>

// sandbox/page/browser.js
extern "C" {
void page_listen(void *host);
void page_wake();
void page_set_title(const char *title);
void page_set_full_screen(int on);
void page_set_clipboard(const char *text);
void page_pick_file();
void page_share(const char *state);
void page_show_licences();
void page_want_text(int on);
}

namespace sandbox {

PageHost::PageHost() : context_(make_canvas_context()) { page_listen(this); }

void PageHost::begin_gui() {
    ImGuiIO &io = ImGui::GetIO();
    io.BackendPlatformName = "page";
    io.ClipboardUserData = this;
    io.GetClipboardTextFn = clipboard;
    io.SetClipboardTextFn = [](void *, const char *text) { page_set_clipboard(text); };
}

const char *PageHost::clipboard(void *host) { return static_cast<PageHost *>(host)->clipboard_.c_str(); }

void PageHost::feed_gui() {
    ImGuiIO &io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(size_.width), static_cast<float>(size_.height)};
    io.DisplayFramebufferScale = {1, 1};
    const double now = seconds();
    io.DeltaTime = static_cast<float>(std::clamp(now - last_frame_, 1e-4, 0.25));
    last_frame_ = now;
    const auto buttons = [&] { return io.MouseDown[0] + 2 * io.MouseDown[1] + 4 * io.MouseDown[2]; };
    while (!pointers_.empty()) {
        const Pointer next = pointers_.front();
        pointers_.pop_front();
        io.MousePos = {next.x, next.y};
        const bool changes = next.buttons != buttons();
        for (int i = 0; i < 3; ++i) {
            io.MouseDown[i] = (next.buttons >> i & 1) != 0;
        }
        if (changes) {
            break;
        }
    }
    io.MouseWheel = std::exchange(wheel_, 0.0F);
    io.AddInputCharactersUTF8(std::exchange(typed_, {}).c_str());
    if (io.WantTextInput != wants_text_) {
        wants_text_ = io.WantTextInput;
        page_want_text(wants_text_ ? 1 : 0); // a keyboard on the screen comes and goes
    }
}

KeysDown PageHost::take_keys() { return keyboard_.take(mods_); }

Arrivals PageHost::take_arrivals() {
    Arrivals taken = std::exchange(arrivals_, {});
    taken.any |= !pointers_.empty() || keyboard_.tapped();
    return taken;
}

bool PageHost::space_held() const { return keyboard_.holds(GLFW_KEY_SPACE); }

double PageHost::seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void PageHost::set_title(const std::string &title) { page_set_title(title.c_str()); }

void PageHost::set_full_screen(bool on) {
    if (std::exchange(full_screen_, on) != on) {
        page_set_full_screen(on ? 1 : 0);
    }
}

bool PageHost::pick_file() {
    page_pick_file();
    return true;
}

void PageHost::share(const std::string &state) { page_share(state.c_str()); }
void PageHost::show_licences() { page_show_licences(); }

void PageHost::wake() {
    arrivals_.any = true;
    page_wake();
}

void PageHost::resize(Size size, float scale) {
    size_ = size;
    scale_ = scale;
    arrivals_.exposed = true;
    wake();
}

void PageHost::move_pointer(float x, float y, int buttons) {
    pointers_.push_back({x, y, buttons});
    wake();
}

void PageHost::lift_pointer() { move_pointer(-FLT_MAX, -FLT_MAX, 0); }

void PageHost::turn_wheel(float notches) {
    wheel_ += notches;
    wake();
}

void PageHost::press_key(int key, int mods, bool down, bool repeated) {
    mods_ = (mods & GLFW_MOD_SUPER) != 0 ? GLFW_MOD_CONTROL | (mods & ~GLFW_MOD_SUPER) : mods; // a Mac's Command
    if (down) {
        keyboard_.press(key, key, mods_);
        arrivals_.keys.push_back({key, mods, repeated});
    } else {
        keyboard_.release(key);
    }
    wake();
}

void PageHost::type(const std::string &text) {
    typed_ += text;
    arrivals_.typed += text;
    arrivals_.question_mark |= text == "?";
    wake();
}

void PageHost::drop(const std::string &path) {
    arrivals_.dropped.push_back(path);
    wake();
}

void PageHost::change_focus() {
    keyboard_.release_all();
    mods_ = 0;
    arrivals_.exposed = true;
    wake();
}

} // namespace sandbox

// What sandbox/page/browser.js calls.
extern "C" {
using sandbox::PageHost;

EMSCRIPTEN_KEEPALIVE void page_resize(PageHost *host, int width, int height, float scale) {
    host->resize({width, height}, scale);
}
EMSCRIPTEN_KEEPALIVE void page_pointer(PageHost *host, float x, float y, int buttons) {
    host->move_pointer(x, y, buttons);
}
EMSCRIPTEN_KEEPALIVE void page_lift(PageHost *host) { host->lift_pointer(); }
EMSCRIPTEN_KEEPALIVE void page_wheel(PageHost *host, float notches) { host->turn_wheel(notches); }
EMSCRIPTEN_KEEPALIVE void page_key(PageHost *host, int key, int mods, int down, int repeated) {
    host->press_key(key, mods, down != 0, repeated != 0);
}
EMSCRIPTEN_KEEPALIVE void page_type(PageHost *host, const char *text) { host->type(text); }
EMSCRIPTEN_KEEPALIVE void page_paste(PageHost *host, const char *text) { host->paste(text); }
EMSCRIPTEN_KEEPALIVE void page_drop(PageHost *host, const char *path) { host->drop(path); }
EMSCRIPTEN_KEEPALIVE void page_focus(PageHost *host) { host->change_focus(); }
}

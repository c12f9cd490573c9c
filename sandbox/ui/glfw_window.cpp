#include "ui/glfw_window.h"

#include "image/error.h"
#include "render/glfw_context.h"
#include "render/lost_display.h"
#include "ui/session/settings.h"

#include <GLFW/glfw3.h>
#include <array>
#include <backends/imgui_impl_glfw.h>
#include <imgui.h>
#include <imgui_internal.h>

namespace sandbox {

namespace {

/// What the user's keyboard has where GLFW's has `key`.
int layout_key(int key, int scancode) {
    if (key == GLFW_KEY_KP_ENTER) {
        return GLFW_KEY_ENTER;
    }
    const bool printable = key >= GLFW_KEY_SPACE && key <= GLFW_KEY_WORLD_2;
    const char *name = printable && key != GLFW_KEY_SPACE ? glfwGetKeyName(key, scancode) : nullptr;
    if (name == nullptr || name[0] == '\0' || name[1] != '\0') {
        return key;
    }
    const char c = name[0];
    return c >= 'a' && c <= 'z' ? GLFW_KEY_A + (c - 'a') : c >= '!' && c <= '`' ? c : key;
}

GlfwInput &input_of(GLFWwindow *window) {
    auto &input = *static_cast<GlfwInput *>(glfwGetWindowUserPointer(window));
    input.arrivals.any = true;
    return input;
}

void on_key(GLFWwindow *window, int key, int scancode, int action, int mods) {
    GlfwInput &input = input_of(window);
    if (action == GLFW_RELEASE) {
        input.keyboard.release(key);
        return;
    }
    const int named = layout_key(key, scancode);
    input.keyboard.press(key, named, mods);
    input.arrivals.keys.push_back({named, mods, action == GLFW_REPEAT});
}

void on_character(GLFWwindow *window, unsigned int character) {
    Arrivals &arrivals = input_of(window).arrivals;
    std::array<char, 5> utf8{};
    arrivals.typed += ImTextCharToUtf8(utf8.data(), character);
    arrivals.question_mark |= character == '?';
}

void on_drop(GLFWwindow *window, int count, const char **paths) {
    input_of(window).arrivals.dropped.assign(paths, paths + count);
}

/// What else arrives may change the picture, too.
template <class... Details> void on_anything(GLFWwindow *window, Details...) { input_of(window); }

template <class... Details> void on_exposure(GLFWwindow *window, Details...) {
    input_of(window).arrivals.exposed = true;
}

void set_hints(Profile profile) {
    set_context_hints(profile);
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    glfwWindowHintString(GLFW_X11_CLASS_NAME, "shading-sandbox");
    glfwWindowHintString(GLFW_X11_INSTANCE_NAME, "shading-sandbox");
}

} // namespace

GlfwWindow::GlfwWindow(Size size, Profile profile) {
    if (glfwInit() != GLFW_TRUE) {
        throw MachineError(
            "no window can be opened here (" + glfw_error() +
            "): run this in a desktop session, or use `shading-sandbox capture`, which needs no display");
    }
    end_when_display_is_lost();
    set_hints(profile);
    window_ = glfwCreateWindow(size.width, size.height, "Shading Sandbox", nullptr, nullptr);
    if (window_ == nullptr) {
        const std::string reason = glfw_error();
        glfwTerminate();
        throw MachineError("no window with " + std::string(name_of(profile)) + " can be opened here (" + reason +
                           "): a newer graphics driver may help; Mesa's llvmpipe (libgl1-mesa-dri) needs no GPU");
    }
    glfwSetWindowSizeLimits(window_, least_window.width, least_window.height, GLFW_DONT_CARE, GLFW_DONT_CARE);
    glfwSetWindowUserPointer(window_, &input_);
    install_callbacks(window_);
    context_ = make_window_context(window_, profile);
}

GlfwWindow::~GlfwWindow() {
    context_.reset();
    glfwDestroyWindow(window_);
    glfwTerminate();
}

void GlfwWindow::begin_gui() {
    ImGui_ImplGlfw_InitForOpenGL(window_, true); // chains to the installed callbacks
    glfwSetKeyCallback(window_, on_key);         // keys are told by take_keys()
}
void GlfwWindow::end_gui() { ImGui_ImplGlfw_Shutdown(); }
void GlfwWindow::feed_gui() { ImGui_ImplGlfw_NewFrame(); }

KeysDown GlfwWindow::take_keys() {
    Keyboard &keyboard = input_.keyboard;
    const auto held = [&](int left, int right, int mod) {
        return keyboard.holds(left) || keyboard.holds(right) ? mod : 0;
    };
    return keyboard.take(held(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL, GLFW_MOD_CONTROL) |
                         held(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT, GLFW_MOD_SHIFT) |
                         held(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT, GLFW_MOD_ALT) |
                         held(GLFW_KEY_LEFT_SUPER, GLFW_KEY_RIGHT_SUPER, GLFW_MOD_SUPER));
}

double GlfwWindow::seconds() const { return glfwGetTime(); }
void GlfwWindow::present() { glfwSwapBuffers(window_); }

void GlfwWindow::install_callbacks(GLFWwindow *window) {
    glfwSetKeyCallback(window, on_key);
    glfwSetCharCallback(window, on_character);
    glfwSetDropCallback(window, on_drop);
    glfwSetCursorPosCallback(window, on_anything);
    glfwSetCursorEnterCallback(window, on_anything);
    glfwSetMouseButtonCallback(window, on_anything);
    glfwSetScrollCallback(window, on_anything);
    glfwSetWindowFocusCallback(window, on_exposure);
    glfwSetWindowCloseCallback(window, on_anything);
    glfwSetWindowRefreshCallback(window, on_exposure);
    glfwSetFramebufferSizeCallback(window, on_exposure);
}

bool GlfwWindow::close_asked() const { return glfwWindowShouldClose(window_) == GLFW_TRUE; }

bool GlfwWindow::space_held() const { return input_.keyboard.holds(GLFW_KEY_SPACE); }

Size GlfwWindow::framebuffer_size() const {
    Size size;
    glfwGetFramebufferSize(window_, &size.width, &size.height);
    return size;
}

float GlfwWindow::content_scale() const {
    float scale = 1;
    glfwGetWindowContentScale(window_, &scale, nullptr);
    return scale > 0 ? scale : 1;
}

void GlfwWindow::set_title(const std::string &title) { glfwSetWindowTitle(window_, title.c_str()); }

void GlfwWindow::show() { glfwShowWindow(window_); }

void GlfwWindow::hide() { glfwHideWindow(window_); }

void GlfwWindow::set_full_screen(bool on) {
    if (on == full_screen_) {
        return;
    }
    full_screen_ = on;
    if (!on) {
        glfwSetWindowMonitor(window_, nullptr, restored_[0], restored_[1], restored_[2], restored_[3], GLFW_DONT_CARE);
        return;
    }
    glfwGetWindowPos(window_, &restored_[0], &restored_[1]);
    glfwGetWindowSize(window_, &restored_[2], &restored_[3]);
    GLFWmonitor *monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode *mode = monitor != nullptr ? glfwGetVideoMode(monitor) : nullptr;
    if (mode != nullptr) {
        glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
    }
}

} // namespace sandbox

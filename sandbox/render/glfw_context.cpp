#include "render/glfw_context.h"

#include "image/error.h"
#include "render/egl_context.h"
#include "render/lost_display.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <dlfcn.h>
#include <fmt/format.h>

namespace sandbox {
namespace {

void use_context(GLFWwindow *window) {
    glfwMakeContextCurrent(window);
    if (glfwGetCurrentContext() != window) {
        throw MachineError("the window's OpenGL context cannot be made current: {}", glfw_error());
    }
}

/// That of one more hidden window.
class WindowWorker final : public WorkerContext {
  public:
    WindowWorker() {
        glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE); // the other hints are as the first window set them
        window_ = glfwCreateWindow(1, 1, "measuring", nullptr, nullptr);
        if (window_ == nullptr) {
            throw MachineError("there can be no second OpenGL context: {}", glfw_error());
        }
    }
    ~WindowWorker() override { glfwDestroyWindow(window_); }
    WindowWorker(const WindowWorker &) = delete;
    WindowWorker &operator=(const WindowWorker &) = delete;

  private:
    void make_current() const override { use_context(window_); }
    void release() const override { glfwMakeContextCurrent(nullptr); }

    GLFWwindow *window_ = nullptr;
};

class WindowContext : public Context {
  public:
    WindowContext(GLFWwindow *window, Profile profile) : window_(window) {
        use_context(window);
        load_functions(profile, glfwGetProcAddress);
    }
    void make_current() const override { use_context(window_); }
    [[nodiscard]] std::unique_ptr<WorkerContext> make_worker() const override {
        auto apart = software() ? make_software_worker(renderer()) : nullptr;
        make_current();
        return apart ? std::move(apart) : std::make_unique<WindowWorker>();
    }

  private:
    GLFWwindow *window_;
};

class HiddenWindow {
  public:
    explicit HiddenWindow(Profile profile) {
        if (glfwInit() != GLFW_TRUE) {
            throw MachineError("--backend glfw needs GLFW and a display server ({}): set DISPLAY, or use --backend egl",
                               glfw_error());
        }
        end_when_display_is_lost();
        set_context_hints(profile);
        glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
        window_ = glfwCreateWindow(16, 16, "shading-sandbox", nullptr, nullptr);
        if (window_ == nullptr) {
            const std::string found = glfw_error();
            glfwTerminate();
            throw MachineError("{} is needed, GLFW found: {}; {}", name_of(profile), found, opengl_install_hint);
        }
    }
    ~HiddenWindow() {
        glfwDestroyWindow(window_);
        glfwTerminate();
    }
    HiddenWindow(const HiddenWindow &) = delete;
    HiddenWindow &operator=(const HiddenWindow &) = delete;
    [[nodiscard]] GLFWwindow *get() const { return window_; }

  private:
    GLFWwindow *window_ = nullptr;
};

class HiddenWindowContext final : private HiddenWindow, public WindowContext {
  public:
    explicit HiddenWindowContext(Profile profile)
        : HiddenWindow(profile), WindowContext(HiddenWindow::get(), profile) {}
};

} // namespace

std::unique_ptr<Context> make_hidden_window_context(Profile profile) {
    return std::make_unique<HiddenWindowContext>(profile);
}

void set_context_hints(Profile profile) {
    const bool es = profile == Profile::es;
    glfwWindowHint(GLFW_CLIENT_API, es ? GLFW_OPENGL_ES_API : GLFW_OPENGL_API);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, es ? 0 : 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, es ? GLFW_OPENGL_ANY_PROFILE : GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, es ? GLFW_FALSE : GLFW_TRUE);
}

std::unique_ptr<Context> make_window_context(GLFWwindow *window, Profile profile) {
    return std::make_unique<WindowContext>(window, profile);
}

std::string glfw_error() {
    const char *reason = nullptr;
    glfwGetError(&reason);
    if (glfwGetVersionString() == nullptr) { // it could not be opened
        const bool opened = dlopen("libglfw.so.3", RTLD_NOW) != nullptr;
        return fmt::format("{}; on Debian: apt install libglfw3", opened ? "libglfw.so.3 is no GLFW" : dlerror());
    }
    return reason != nullptr ? reason : "no reason given";
}

} // namespace sandbox

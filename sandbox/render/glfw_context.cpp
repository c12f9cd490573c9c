#include "render/glfw_context.h"

#include "image/error.h"
#include "render/egl_context.h"
#include "render/lost_display.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

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
    explicit WindowContext(GLFWwindow *window) : window_(window) {
        use_context(window);
        load_functions(glfwGetProcAddress);
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
    HiddenWindow() {
        if (glfwInit() != GLFW_TRUE) {
            throw MachineError("--backend glfw needs a display server, found none: set DISPLAY, or use --backend egl");
        }
        end_when_display_is_lost();
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
        window_ = glfwCreateWindow(16, 16, "shading-sandbox", nullptr, nullptr);
        if (window_ == nullptr) {
            const std::string found = glfw_error();
            glfwTerminate();
            throw MachineError("OpenGL 3.3 is needed, GLFW found: {}; {}", found, opengl_install_hint);
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
    HiddenWindowContext() : WindowContext(HiddenWindow::get()) {}
};

} // namespace

std::unique_ptr<Context> make_hidden_window_context() { return std::make_unique<HiddenWindowContext>(); }
std::unique_ptr<Context> make_window_context(GLFWwindow *window) { return std::make_unique<WindowContext>(window); }

std::string glfw_error() {
    const char *reason = nullptr;
    glfwGetError(&reason);
    return reason != nullptr ? reason : "no reason given";
}

} // namespace sandbox

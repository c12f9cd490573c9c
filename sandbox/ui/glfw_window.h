#pragma once

#include "ui/host.h"

#include <utility>

struct GLFWwindow;

namespace sandbox {

/// What GLFW has told.
struct GlfwInput {
    Arrivals arrivals;
    Keyboard keyboard;
};

/// The operating system's window.
class GlfwWindow final : public Host {
  public:
    /// Hidden until show(). Throws MachineError, which says what to do, if there is no display or no OpenGL 3.3.
    GlfwWindow(Size size, Profile profile);
    ~GlfwWindow() override;

    [[nodiscard]] Context &context() override { return *context_; }
    void begin_gui() override;
    void end_gui() override;
    void feed_gui() override;
    [[nodiscard]] KeysDown take_keys() override;
    [[nodiscard]] Arrivals take_arrivals() override { return std::exchange(input_.arrivals, {}); }
    [[nodiscard]] bool space_held() const override;
    [[nodiscard]] Size framebuffer_size() const override;
    [[nodiscard]] float content_scale() const override;
    [[nodiscard]] double seconds() const override;
    void present() override;
    void set_title(const std::string &title) override;
    void set_full_screen(bool on) override;

    [[nodiscard]] bool close_asked() const;
    void show();
    void hide();

  private:
    static void install_callbacks(GLFWwindow *window);

    GLFWwindow *window_ = nullptr;
    std::unique_ptr<Context> context_;
    GlfwInput input_;
    bool full_screen_ = false;
    int restored_[4] = {0, 0, 0, 0}; ///< x, y, width, height before full screen
};

} // namespace sandbox

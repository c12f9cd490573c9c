#pragma once

#include "image/image.h"

#include <string>
#include <utility>
#include <vector>

struct GLFWwindow;

namespace sandbox {

/// A key as pressed: GLFW's names, after the keyboard's layout.
struct KeyPress {
    int key, mods;
    bool repeated;
};

/// Input since the last take_arrivals().
struct Arrivals {
    bool any = false; ///< anything at all that may change the picture
    std::vector<KeyPress> keys;
    bool question_mark = false;
    std::vector<std::string> dropped; ///< paths
};

/// The operating system's window. Its OpenGL 3.3 context is made current by make_window_context().
class GlfwWindow {
  public:
    /// Hidden until show(). Throws MachineError, which says what to do, if there is no display or no OpenGL 3.3.
    explicit GlfwWindow(Size size);
    ~GlfwWindow();
    GlfwWindow(const GlfwWindow &) = delete;
    GlfwWindow &operator=(const GlfwWindow &) = delete;

    [[nodiscard]] GLFWwindow *handle() const { return window_; }
    [[nodiscard]] Arrivals take_arrivals() { return std::exchange(arrivals_, {}); }
    [[nodiscard]] bool something_arrived() const { return arrivals_.any; }
    [[nodiscard]] bool close_asked() const;
    [[nodiscard]] bool space_held() const;
    /// Physical pixels; (0, 0) while minimised.
    [[nodiscard]] Size framebuffer_size() const;
    /// The screen's own magnification: 2 on a dense one.
    [[nodiscard]] float content_scale() const;
    void set_title(const std::string &title);
    void show();
    void hide();
    void set_full_screen(bool on);

  private:
    static void install_callbacks(GLFWwindow *window);

    GLFWwindow *window_ = nullptr;
    Arrivals arrivals_;
    bool full_screen_ = false;
    int restored_[4] = {0, 0, 0, 0}; ///< x, y, width, height before full screen
};

} // namespace sandbox

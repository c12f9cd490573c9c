#pragma once

#include <memory>
#include <string>

struct GLFWwindow;

namespace sandbox {

enum class Backend { egl, glfw };

/// A current OpenGL 3.3 core context with its functions loaded. Throws MachineError naming what was found and what to
/// install. One at a time per thread.
class Context {
  public:
    /// No window: EGL (surfaceless, then device, then default display), or a hidden GLFW window.
    static std::unique_ptr<Context> headless(Backend backend = Backend::egl);
    /// Loads the functions of a window's context, which is made current.
    static std::unique_ptr<Context> of_window(GLFWwindow *window);

    virtual ~Context() = default;
    Context(const Context &) = delete;
    Context &operator=(const Context &) = delete;

    /// GL_RENDERER, GL_VERSION: "llvmpipe (LLVM 15.0.6, 256 bits)", "3.3 (Core Profile) Mesa 22.3.6".
    [[nodiscard]] std::string renderer() const;
    [[nodiscard]] std::string version() const;
    /// Of the context that is current: true for llvmpipe, softpipe, swrast: time with glFinish.
    [[nodiscard]] static bool software();

  protected:
    Context() = default;
    /// Loads the functions of the context that is current; throws MachineError below OpenGL 3.3.
    static void load_functions(void (*(*get_proc_address)(const char *))());
};

} // namespace sandbox

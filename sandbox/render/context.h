#pragma once

#include "image/image.h"

#include <glm/vec3.hpp>

#include <memory>
#include <string>
#include <string_view>

namespace sandbox {

enum class Backend { egl, glfw };

/// Which OpenGL: 3.3 core, or ES 3.0 as browsers and phones have it. One a process: both share their functions' names.
enum class Profile { core, es };
#ifdef SANDBOX_ES
constexpr Profile default_profile = Profile::es;
#else
constexpr Profile default_profile = Profile::core;
#endif
/// "OpenGL 3.3", "OpenGL ES 3.0".
std::string_view name_of(Profile profile);
/// Of the context whose functions are loaded.
Profile current_profile();

/// A second OpenGL context for one more thread; the functions are those that the first one loaded.
class WorkerContext {
  public:
    WorkerContext() = default;
    virtual ~WorkerContext() = default;
    WorkerContext(const WorkerContext &) = delete;
    WorkerContext &operator=(const WorkerContext &) = delete;

    /// While it lives, the calling thread draws in this context. Throws MachineError if the driver refuses.
    class Current {
      public:
        explicit Current(const WorkerContext &context) : context_(context) { context_.make_current(); }
        ~Current() { context_.release(); }
        Current(const Current &) = delete;
        Current &operator=(const Current &) = delete;

      private:
        const WorkerContext &context_;
    };

  private:
    virtual void make_current() const = 0;
    virtual void release() const = 0;
};

/// A current OpenGL context of a profile with its functions loaded. One at a time per thread.
class Context {
  public:
    /// Without a visible window: through EGL, or in a hidden GLFW window. Throws MachineError saying what was found and
    /// what to install.
    static std::unique_ptr<Context> headless(Backend backend = Backend::egl, Profile profile = default_profile);

    virtual ~Context() = default;
    Context(const Context &) = delete;
    Context &operator=(const Context &) = delete;

    /// GL_RENDERER, GL_VERSION: "llvmpipe (LLVM 15.0.6, 256 bits)", "3.3 (Core Profile) Mesa 22.3.6".
    [[nodiscard]] std::string renderer() const;
    [[nodiscard]] std::string version() const;
    /// Again, on its thread, after a worker's was. Throws MachineError if the driver refuses.
    virtual void make_current() const = 0;
    /// Of the same driver; made and destroyed on this context's thread, before it. Throws MachineError where there can
    /// be no second context.
    [[nodiscard]] virtual std::unique_ptr<WorkerContext> make_worker() const = 0;
    /// Whether the current context draws on the CPU: llvmpipe, softpipe, swrast. Their times need glFinish.
    [[nodiscard]] static bool software();

  protected:
    Context() = default;
    /// Loads the functions of the current context; a page's are linked. Throws MachineError below what the profile asks
    /// for.
    static void load_functions(Profile profile, void (*(*get_proc_address)(const char *))());
};

/// Binds the window's framebuffer (0: its own), all of it, and clears it to `background` as displayed, [0, 1]: before a
/// frame is drawn into it.
void begin_window_surface(unsigned framebuffer, Size size, const glm::vec3 &background);
/// What has been drawn there, top row first.
ByteImage read_window_surface(unsigned framebuffer, Size size);

constexpr std::string_view opengl_install_hint =
    "install a driver, or Mesa's software one (Debian and Ubuntu: apt install libegl1 libgl1-mesa-dri)";

} // namespace sandbox

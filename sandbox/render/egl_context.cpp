#include "image/error.h"
#include "render/platform_context.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>
#include <cstring>
#include <vector>

namespace sandbox {
namespace {

bool has_extension(const char *list, const char *name) { return list != nullptr && std::strstr(list, name) != nullptr; }

/// The displays to try, in order: surfaceless, each device, the default one.
std::vector<EGLDisplay> candidate_displays() {
    std::vector<EGLDisplay> displays;
    const char *client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    const auto get_platform_display =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (get_platform_display != nullptr && has_extension(client, "EGL_MESA_platform_surfaceless")) {
        displays.push_back(get_platform_display(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr));
    }
    const auto query_devices = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
    if (get_platform_display != nullptr && query_devices != nullptr &&
        has_extension(client, "EGL_EXT_platform_device")) {
        std::array<EGLDeviceEXT, 16> devices{};
        EGLint count = 0;
        query_devices(static_cast<EGLint>(devices.size()), devices.data(), &count);
        for (EGLint i = 0; i < count; ++i) {
            displays.push_back(
                get_platform_display(EGL_PLATFORM_DEVICE_EXT, devices[static_cast<std::size_t>(i)], nullptr));
        }
    }
    displays.push_back(eglGetDisplay(EGL_DEFAULT_DISPLAY));
    return displays;
}

class EglContext final : public Context {
  public:
    /// Makes a 3.3 core context current without a surface; false where this display cannot.
    bool try_display(EGLDisplay display) {
        if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) != EGL_TRUE) {
            return false;
        }
        displays_.push_back(display);
        if (eglBindAPI(EGL_OPENGL_API) != EGL_TRUE) {
            return false;
        }
        constexpr std::array<EGLint, 5> config_attributes{EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0,
                                                          EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        if (eglChooseConfig(display, config_attributes.data(), &config, 1, &count) != EGL_TRUE || count == 0) {
            return false;
        }
        constexpr std::array<EGLint, 7> attributes{
            EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
        context_ = eglCreateContext(display, config, EGL_NO_CONTEXT, attributes.data());
        if (context_ == EGL_NO_CONTEXT) {
            found_ = older_version(display, config);
            return false;
        }
        display_ = display;
        return eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE;
    }

    static void load() { load_functions(eglGetProcAddress); }

    /// What was there instead of OpenGL 3.3, for the message.
    [[nodiscard]] const std::string &found() const { return found_; }

    EglContext() = default;
    ~EglContext() override {
        if (context_ != EGL_NO_CONTEXT) {
            eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
            eglDestroyContext(display_, context_);
        }
        for (const EGLDisplay display : displays_) {
            eglTerminate(display);
        }
    }
    EglContext(const EglContext &) = delete;
    EglContext &operator=(const EglContext &) = delete;

  private:
    /// The version of whatever context the display does give.
    static std::string older_version(EGLDisplay display, EGLConfig config) {
        const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
        if (context == EGL_NO_CONTEXT) {
            return {};
        }
        std::string text;
        const auto get_string = reinterpret_cast<const unsigned char *(*)(unsigned)>(eglGetProcAddress("glGetString"));
        if (get_string != nullptr && eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_TRUE) {
            constexpr unsigned gl_version = 0x1F02;
            const auto *version = reinterpret_cast<const char *>(get_string(gl_version));
            text = version != nullptr ? version : "";
            eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        }
        eglDestroyContext(display, context);
        return text;
    }

    std::vector<EGLDisplay> displays_;
    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
    std::string found_;
};

} // namespace

std::unique_ptr<Context> make_egl_context() {
    auto context = std::make_unique<EglContext>();
    for (const EGLDisplay display : candidate_displays()) {
        if (context->try_display(display)) {
            EglContext::load();
            return context;
        }
    }
    const std::string found = context->found().empty() ? "no OpenGL through EGL" : "OpenGL " + context->found();
    throw MachineError("OpenGL 3.3 is needed, found " + found + ": " + install_hint);
}

} // namespace sandbox

#include "render/egl_context.h"

#include "image/error.h"
#include "render/gl.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/format.h>

#include <array>
#include <cstring>
#include <functional>
#include <span>
#include <utility>

namespace sandbox {
namespace {

bool has_extension(const char *list, const char *name) { return list != nullptr && std::strstr(list, name) != nullptr; }

/// Offers displays, in order, until one is taken: surfaceless, each device, the default one. Later ones are not even
/// looked up: EGL would search the machine for devices.
void offer_displays(const std::function<bool(EGLDisplay)> &take) {
    const char *client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    const auto get_platform_display =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (get_platform_display != nullptr && has_extension(client, "EGL_MESA_platform_surfaceless") &&
        take(get_platform_display(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr))) {
        return;
    }
    const auto query_devices = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
    if (get_platform_display != nullptr && query_devices != nullptr &&
        has_extension(client, "EGL_EXT_platform_device")) {
        std::array<EGLDeviceEXT, 16> devices{};
        EGLint count = 0;
        if (query_devices(static_cast<EGLint>(devices.size()), devices.data(), &count) == EGL_TRUE) {
            for (const EGLDeviceEXT device : std::span(devices).first(static_cast<std::size_t>(count))) {
                if (take(get_platform_display(EGL_PLATFORM_DEVICE_EXT, device, nullptr))) {
                    return;
                }
            }
        }
    }
    take(eglGetDisplay(EGL_DEFAULT_DISPLAY));
}

constexpr std::array<EGLint, 7> core_3_3{
    EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
    EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
constexpr std::array<EGLint, 5> es_3_0{EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 0, EGL_NONE};
const EGLint *attributes_of(Profile profile) { return profile == Profile::es ? es_3_0.data() : core_3_3.data(); }

/// An initialised display, and how contexts on it are configured.
class OpenDisplay {
  public:
    OpenDisplay(EGLDisplay handle, Profile profile)
        : handle_(handle), profile_(profile), api_(profile == Profile::es ? EGL_OPENGL_ES_API : EGL_OPENGL_API) {
        initialised_ = handle_ != EGL_NO_DISPLAY && eglInitialize(handle_, nullptr, nullptr) == EGL_TRUE;
        const EGLint kind = profile == Profile::es ? EGL_OPENGL_ES3_BIT : EGL_OPENGL_BIT;
        const std::array<EGLint, 5> wanted{EGL_RENDERABLE_TYPE, kind, EGL_SURFACE_TYPE, 0, EGL_NONE};
        EGLint count = 0;
        usable_ = initialised_ && eglBindAPI(api_) == EGL_TRUE &&
                  eglChooseConfig(handle_, wanted.data(), &config_, 1, &count) == EGL_TRUE && count > 0;
    }
    ~OpenDisplay() {
        if (initialised_) {
            eglTerminate(handle_);
        }
    }
    OpenDisplay(const OpenDisplay &) = delete;
    OpenDisplay &operator=(const OpenDisplay &) = delete;

    /// False where it cannot draw OpenGL.
    [[nodiscard]] bool usable() const { return usable_; }
    [[nodiscard]] Profile profile() const { return profile_; }
    /// EGL_NO_CONTEXT if it refuses.
    [[nodiscard]] EGLContext create_context(const EGLint *attributes) const {
        return eglCreateContext(handle_, config_, EGL_NO_CONTEXT, attributes);
    }
    void destroy_context(EGLContext context) const { eglDestroyContext(handle_, context); }
    /// EGL_NO_CONTEXT: none. False if it refuses.
    [[nodiscard]] bool make_current(EGLContext context) const {
        eglBindAPI(api_); // of this thread
        return eglMakeCurrent(handle_, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_TRUE;
    }

  private:
    EGLDisplay handle_;
    Profile profile_;
    EGLenum api_;
    EGLConfig config_ = nullptr;
    bool initialised_ = false, usable_ = false;
};

class EglWorker final : public WorkerContext {
  public:
    /// Throws MachineError.
    explicit EglWorker(std::shared_ptr<const OpenDisplay> display)
        : display_(std::move(display)), context_(display_->create_context(attributes_of(display_->profile()))) {
        if (context_ == EGL_NO_CONTEXT) {
            throw MachineError("there can be no second OpenGL context (EGL error {:#06x})", eglGetError());
        }
    }
    ~EglWorker() override { display_->destroy_context(context_); }
    EglWorker(const EglWorker &) = delete;
    EglWorker &operator=(const EglWorker &) = delete;

  private:
    void make_current() const override {
        if (!display_->make_current(context_)) {
            throw MachineError("the second OpenGL context cannot be made current (EGL error {:#06x})", eglGetError());
        }
    }
    void release() const override { static_cast<void>(display_->make_current(EGL_NO_CONTEXT)); }

    std::shared_ptr<const OpenDisplay> display_;
    EGLContext context_;
};

/// A display, and a context on it that is current without a surface.
class EglContext final : public Context {
  public:
    EglContext(EGLDisplay display, Profile profile) : display_(std::make_shared<OpenDisplay>(display, profile)) {}
    ~EglContext() override {
        if (context_ != EGL_NO_CONTEXT) {
            static_cast<void>(display_->make_current(EGL_NO_CONTEXT));
            display_->destroy_context(context_);
        }
    }
    EglContext(const EglContext &) = delete;
    EglContext &operator=(const EglContext &) = delete;

    /// Makes a context of the profile current. False where this display has none; then `found` says which version it
    /// has instead, unless an earlier display has said that already.
    bool start(std::string &found) {
        if (!display_->usable()) {
            return false;
        }
        if (make_with(attributes_of(display_->profile()))) {
            load_functions(display_->profile(), eglGetProcAddress);
            return true;
        }
        if (found.empty() && make_with(nullptr)) {
            found = "OpenGL " + version_string();
        }
        return false;
    }

    void make_current() const override {
        if (!display_->make_current(context_)) {
            throw MachineError("the OpenGL context cannot be made current again (EGL error {:#06x})", eglGetError());
        }
    }
    [[nodiscard]] std::unique_ptr<WorkerContext> make_worker() const override {
        auto apart = software() ? make_software_worker(renderer()) : nullptr;
        make_current();
        return apart ? std::move(apart) : std::make_unique<EglWorker>(display_);
    }

  private:
    /// And makes it current.
    bool make_with(const EGLint *attributes) {
        if (context_ == EGL_NO_CONTEXT) {
            context_ = display_->create_context(attributes);
        }
        return context_ != EGL_NO_CONTEXT && display_->make_current(context_);
    }

    /// Of the current context, whose functions are not loaded because it is too old.
    static std::string version_string() {
        constexpr unsigned gl_version = 0x1F02;
        const auto get_string = reinterpret_cast<const unsigned char *(*)(unsigned)>(eglGetProcAddress("glGetString"));
        const unsigned char *version = get_string != nullptr ? get_string(gl_version) : nullptr;
        return version != nullptr ? reinterpret_cast<const char *>(version) : "of an unknown version";
    }

    std::shared_ptr<const OpenDisplay> display_;
    EGLContext context_ = EGL_NO_CONTEXT;
};

} // namespace

std::unique_ptr<Context> make_egl_context(Profile profile) {
    std::string found;
    std::unique_ptr<EglContext> context;
    offer_displays([&](EGLDisplay display) {
        auto started = std::make_unique<EglContext>(display, profile);
        context = started->start(found) ? std::move(started) : nullptr;
        return context != nullptr;
    });
    if (context != nullptr) {
        return context;
    }
    throw MachineError("{} is needed, found {}: {}", name_of(profile), found.empty() ? "no OpenGL through EGL" : found,
                       opengl_install_hint);
}

std::unique_ptr<WorkerContext> make_software_worker(const std::string &renderer) {
    const EGLDisplay current = eglGetCurrentDisplay();
    std::unique_ptr<WorkerContext> taken;
    offer_displays([&](EGLDisplay candidate) {
        if (candidate == current) {
            return false;
        }
        const auto display = std::make_shared<const OpenDisplay>(candidate, current_profile());
        if (!display->usable()) {
            return false;
        }
        try {
            auto worker = std::make_unique<EglWorker>(display);
            const WorkerContext::Current here(*worker);
            if (reinterpret_cast<const char *>(glGetString(GL_RENDERER)) == renderer) {
                taken = std::move(worker);
            }
        } catch (const MachineError &) { // another may do
        }
        return taken != nullptr;
    });
    return taken;
}

} // namespace sandbox

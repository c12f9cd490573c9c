#include "bare_context.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <cstdio>
#include <cstdlib>
#include <glad/gl.h>

namespace sandbox {

namespace {

/// Mesa's surfaceless platform or, of drivers that have none, the first device.
EGLDisplay initialized_display() {
    const auto platform_display =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    EGLDisplay display = platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (eglInitialize(display, nullptr, nullptr) == EGL_FALSE) {
        const auto query = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
        EGLDeviceEXT device = nullptr;
        EGLint devices = 0;
        query(1, &device, &devices);
        display = platform_display(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
        eglInitialize(display, nullptr, nullptr);
    }
    return display;
}

} // namespace

void make_bare_context() {
    EGLDisplay display = initialized_display();
    eglBindAPI(EGL_OPENGL_API);
    const EGLint any[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint configs = 0;
    eglChooseConfig(display, any, &config, 1, &configs);
    const EGLint core33[] = {
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, core33);
    if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_FALSE ||
        gladLoadGL(eglGetProcAddress) == 0) {
        std::fprintf(stderr, "no OpenGL 3.3\n");
        std::exit(3);
    }
}

} // namespace sandbox

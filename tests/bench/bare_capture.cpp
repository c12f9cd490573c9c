#include "textbook.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <cstdio>
#include <glad/gl.h>

#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb_image_write.h>
#pragma GCC diagnostic pop

/// The least program that draws a picture and writes a PNG: EGL without a surface, the textbook program, stb.
int main(int argc, char **argv) {
    using namespace sandbox;
    if (argc != 2) {
        std::fprintf(stderr, "usage: bare_capture FILE.png\n");
        return 2;
    }
    const auto platform_display =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    EGLDisplay display = platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    eglInitialize(display, nullptr, nullptr);
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
        std::fprintf(stderr, "bare_capture: no OpenGL 3.3\n");
        return 3;
    }
    constexpr Size size{1280, 720};
    const Textbook textbook(three_lights_on_a_sphere(), Textbook::Shading::per_pixel, Textbook::Highlight::blinn_phong,
                            size);
    textbook.frame();
    const auto bytes = textbook.read_bytes();
    return stbi_write_png(argv[1], size.width, size.height, 3, bytes.data(), 3 * size.width) != 0 ? 0 : 2;
}

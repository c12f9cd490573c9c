#include "render/context.h"

#include "image/error.h"
#include "render/gl.h"
#include "render/gl_state.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iostream>
#include <vector>

namespace sandbox {
namespace {

std::string gl_string(unsigned name) {
    const auto *text = reinterpret_cast<const char *>(glGetString(name));
    return text != nullptr ? text : "unknown";
}

#if !defined(NDEBUG) && !defined(__EMSCRIPTEN__)
void GLAD_API_PTR print_message(GLenum, GLenum type, GLuint, GLenum, GLsizei, const char *message, const void *) {
    if (type == GL_DEBUG_TYPE_ERROR || type == GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR) {
        std::cerr << "OpenGL: " << message << '\n';
    }
}

void listen_to_debug_messages() {
    if (GLAD_GL_KHR_debug != 0 && !is_es()) { // ES calls the functions otherwise
        glEnable(GL_DEBUG_OUTPUT);
        glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
        glDebugMessageCallback(print_message, nullptr);
    }
}
#endif

#ifdef __EMSCRIPTEN__
constexpr bool in_browser = true;
constexpr unsigned renderer_name = 0x9246; // WebGL's GL_RENDERER says the browser's name
#else
constexpr bool in_browser = false;
constexpr unsigned renderer_name = GL_RENDERER;
#endif

} // namespace

std::string_view name_of(Profile profile) { return profile == Profile::es ? "OpenGL ES 3.0" : "OpenGL 3.3"; }

Profile current_profile() { return is_es() ? Profile::es : Profile::core; }

void Context::load_functions([[maybe_unused]] Profile profile,
                             [[maybe_unused]] void (*(*get_proc_address)(const char *))()) {
#ifndef __EMSCRIPTEN__
    const bool es = profile == Profile::es;
    const int version = es ? gladLoadGLES2(get_proc_address) : gladLoadGL(get_proc_address);
    if (version < (es ? GLAD_MAKE_VERSION(3, 0) : GLAD_MAKE_VERSION(3, 3))) {
        throw MachineError("{} is needed, found {}: {}", name_of(profile),
                           version == 0 ? "none" : gl_string(GL_VERSION) + " by " + gl_string(GL_RENDERER),
                           opengl_install_hint);
    }
#ifndef NDEBUG
    listen_to_debug_messages();
#endif
#endif
    for (const char *extension : {"GL_EXT_color_buffer_float", "GL_OES_texture_float_linear"}) {
        if (is_es() && !has_gl_extension(extension)) {
            throw MachineError("this {} lacks {}, without which light cannot be kept as float32: try {}",
                               in_browser ? "browser's WebGL" : "OpenGL ES", extension,
                               in_browser ? "another browser, a newer one, or another device" : "--profile core");
        }
    }
}

std::string Context::renderer() const { return gl_string(renderer_name); }
std::string Context::version() const { return gl_string(GL_VERSION); }

bool Context::software() {
    const std::string name = gl_string(renderer_name);
    return std::ranges::any_of(std::array{"llvmpipe", "softpipe", "swrast", "SWR"},
                               [&](const char *known) { return name.find(known) != std::string::npos; });
}

void begin_window_surface(unsigned framebuffer, Size size, const glm::vec3 &background) {
    {
        const PassState pass(framebuffer, size, DepthTest::off);
        glClearColor(background.r, background.g, background.b, 1);
        glClear(GL_COLOR_BUFFER_BIT);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
}

ByteImage read_window_surface(unsigned framebuffer, Size size) {
    ByteImage image{size, {}};
    const auto width = static_cast<std::size_t>(size.width);
    std::vector<std::array<std::uint8_t, 4>> row(width); // ES reads all four or none
    image.rgb.reserve(3 * width * static_cast<std::size_t>(size.height));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    glReadBuffer(framebuffer == 0 ? GL_BACK : GL_COLOR_ATTACHMENT0);
    for (int y = 0; y < size.height; ++y) {
        glReadPixels(0, size.height - 1 - y, size.width, 1, GL_RGBA, GL_UNSIGNED_BYTE, row.data());
        for (const auto &pixel : row) {
            image.rgb.insert(image.rgb.end(), pixel.begin(), pixel.begin() + 3);
        }
    }
    check_gl("read the window back");
    return image;
}

} // namespace sandbox

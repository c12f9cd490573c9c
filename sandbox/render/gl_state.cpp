#include "render/gl_state.h"

#include "image/error.h"
#include "render/gl.h"
#ifdef __EMSCRIPTEN__
#include "image/page_thread.h"
#endif

#include <fmt/format.h>

namespace sandbox {
namespace {

void set_defaults() {
    glDisable(GL_BLEND);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glFrontFace(GL_CCW);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glActiveTexture(GL_TEXTURE0);
    glBindVertexArray(0);
}

} // namespace

PassState::PassState(unsigned framebuffer, Size size, DepthTest depth_test) {
    set_defaults();
    if (depth_test == DepthTest::on) {
        glEnable(GL_DEPTH_TEST);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, size.width, size.height);
}

PassState::~PassState() { set_defaults(); }

#ifdef __EMSCRIPTEN__
bool is_es() { return true; }
#else
bool is_es() { return GLAD_GL_ES_VERSION_3_0 != 0; }
#endif

void let_driver_catch_up() {
#ifdef __EMSCRIPTEN__
    if (!can_suspend()) {
        return;
    }
    const GLsync fence = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    glFlush();
    while (glClientWaitSync(fence, 0, 0) == GL_TIMEOUT_EXPIRED) {
        suspend();
    }
    glDeleteSync(fence);
#endif
}

/// A browser's glFinish() waits for nothing, so a pixel is read there: of this framebuffer, since a driver may put off
/// the rest.
void finish_drawing([[maybe_unused]] unsigned framebuffer, [[maybe_unused]] unsigned type) {
#ifdef __EMSCRIPTEN__
    GLint bound = 0;
    float pixel[4]; // or four bytes
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &bound);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    glReadBuffer(GL_COLOR_ATTACHMENT0); // object ids may have been read before
    glReadPixels(0, 0, 1, 1, GL_RGBA, type, pixel);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(bound));
#else
    glFinish();
#endif
}

void finish_drawing_in_turns(unsigned framebuffer, unsigned type) {
    let_driver_catch_up();
    finish_drawing(framebuffer, type);
}

void forget_gl_errors() {
    while (glGetError() != GL_NO_ERROR) {
    }
}

bool has_gl_extension(std::string_view name) {
    GLint count = 0;
    glGetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLint i = 0; i < count; ++i) {
        if (name == reinterpret_cast<const char *>(glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i)))) {
            return true;
        }
    }
    return false;
}

void check_gl(std::string_view action) {
    let_driver_catch_up();
    const GLenum error = glGetError();
    if (error != GL_NO_ERROR) {
        throw MachineError("OpenGL cannot {}: {}", action,
                           error == GL_OUT_OF_MEMORY ? "out of memory" : fmt::format("error {:#06x}", error));
    }
}

} // namespace sandbox

#include "render/gl_state.h"

#include "image/error.h"

#include <fmt/format.h>
#include <glad/gl.h>

namespace sandbox {
namespace {

void set_defaults() {
    glDisable(GL_BLEND);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_DEPTH_CLAMP);
    glDisable(GL_CULL_FACE);
    glDisable(GL_POLYGON_OFFSET_LINE);
    glPolygonOffset(0, 0);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
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

void check_gl(std::string_view action) {
    const GLenum error = glGetError();
    if (error != GL_NO_ERROR) {
        throw MachineError("OpenGL cannot {}: {}", action,
                           error == GL_OUT_OF_MEMORY ? "out of memory" : fmt::format("error {:#06x}", error));
    }
}

} // namespace sandbox

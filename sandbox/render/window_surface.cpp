#include "render/window_surface.h"

#include <glad/gl.h>

namespace sandbox {

void begin_window_surface(Size framebuffer) {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, framebuffer.width, framebuffer.height);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
}

} // namespace sandbox

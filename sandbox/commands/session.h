#pragma once

#include "commands/common.h"
#include "render/context.h"
#include "render/renderer.h"

#include <memory>

namespace sandbox {

/// OpenGL without a window, and the renderer in it.
class DrawingSession {
  public:
    /// Throws MachineError where there is no OpenGL 3.3.
    explicit DrawingSession(const CommonOptions &common)
        : context_(Context::headless(common.backend == "glfw" ? Backend::glfw : Backend::egl)),
          renderer_(scene_assets(common), ShaderParts(shader_assets(common))) {
        if (common.verbose) {
            note("OpenGL: " + context_->renderer() + ", " + context_->version());
        }
    }

    [[nodiscard]] Renderer &renderer() { return renderer_; }
    [[nodiscard]] const Context &context() const { return *context_; }

  private:
    std::unique_ptr<Context> context_; // outlives the renderer
    Renderer renderer_;
};

} // namespace sandbox

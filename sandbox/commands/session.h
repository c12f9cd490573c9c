#pragma once

#include "commands/common.h"
#include "render/renderer.h"

#include <memory>

namespace sandbox {

/// OpenGL without a window, and the renderer in it.
class DrawingSession {
  public:
    /// Throws MachineError where there is no OpenGL 3.3.
    explicit DrawingSession(const CommonOptions &common);

    [[nodiscard]] Renderer &renderer() { return renderer_; }
    [[nodiscard]] const Context &context() const { return *context_; }

  private:
    std::unique_ptr<Context> context_; // outlives the renderer
    Renderer renderer_;
};

} // namespace sandbox

#pragma once

#include "commands/common.h"
#include "render/context.h"
#include "render/own_process.h"
#include "render/renderer.h"

#include <memory>

namespace sandbox {

/// OpenGL without a window, and the renderer in it.
class DrawingSession {
  public:
    /// Own shading is not trusted to share a process with the work; where its run time is the result, it must.
    enum class Own { drawn_apart, drawn_here };

    /// Throws MachineError where there is no OpenGL of the profile.
    explicit DrawingSession(const CommonOptions &common, Own own = Own::drawn_apart, OwnLimits limits = {})
        : own_(own_server_command(scene_assets(common), shader_assets(common), common.profile, common.backend), limits),
          context_(Context::headless(common.backend == "glfw" ? Backend::glfw : Backend::egl, common.profile)),
          renderer_(scene_assets(common), ShaderParts(shader_assets(common))) {
        if (own == Own::drawn_apart) {
            renderer_.draw_own_by(drawn_by(own_));
        }
        if (common.verbose) {
            note("OpenGL: " + context_->renderer() + ", " + context_->version());
        }
    }

    [[nodiscard]] Renderer &renderer() { return renderer_; }
    [[nodiscard]] const Context &context() const { return *context_; }
    DrawingSession(const DrawingSession &) = delete;
    DrawingSession &operator=(const DrawingSession &) = delete;

  private:
    OwnProcess own_;
    std::unique_ptr<Context> context_; // outlives the renderer
    Renderer renderer_;
};

} // namespace sandbox

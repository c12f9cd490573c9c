#include "commands/session.h"

namespace sandbox {

DrawingSession::DrawingSession(const CommonOptions &common)
    : context_(Context::headless(common.backend)), renderer_(scene_assets(common), ShaderParts(shader_assets(common))) {
    if (common.verbose) {
        note("OpenGL: " + context_->renderer() + ", " + context_->version());
    }
}

} // namespace sandbox

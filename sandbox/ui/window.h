#pragma once

#include "scene/assets.h"
#include "shading/technique.h"
#include "ui/session/open_file.h"

namespace sandbox {

struct WindowOptions {
    OpenedFile file; ///< shown first
    /// If the file names no techniques:
    Technique left{.frequency = Frequency::per_vertex, .model = Model::phong};
    Technique right{.frequency = Frequency::per_pixel, .model = Model::blinn_phong};
    Assets assets{"assets"};
    Assets shaders{"shaders"};
};

/// Opens the window and returns when it is closed, with the process's exit code (0).
/// Throws MachineError if there is no display or no OpenGL 3.3.
int run_window(const WindowOptions &options);

} // namespace sandbox

#pragma once

namespace sandbox {

/// OpenGL 3.3 by EGL without a surface, as little as it takes, loaded and current; ends the process where there is
/// none.
void make_bare_context();

} // namespace sandbox

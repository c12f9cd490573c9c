#pragma once

#include "capture/picture.h"
#include "render/renderer.h"

#include <glm/vec3.hpp>

namespace sandbox {

constexpr glm::vec3 wireframe_color{0.9F, 0.9F, 0.9F}; ///< linear RGB

/// What draws the pictures of captures; `renderer` must outlive it.
Painters painters_of(Renderer &renderer, bool wireframe);

} // namespace sandbox

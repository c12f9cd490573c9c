#pragma once

#include "image/image.h"
#include "scene/scene.h"
#include "shading/technique.h"

#include <functional>

namespace sandbox {

using DrawPicture = std::function<Image(const Scene &, const Technique &, Size)>;

/// ObjectResources::window_grid of a renderer of OpenGL, found by drawing: a square that the picture moves by less than
/// half a step stays the same to the last bit where positions are rounded, and slides where they are not. How fine the
/// steps are, the driver says (GL_SUBPIXEL_BITS).
int measured_window_grid(const DrawPicture &draw);

} // namespace sandbox

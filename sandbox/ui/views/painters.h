#pragma once

#include "capture/picture.h"
#include "render/renderer.h"

namespace sandbox {

/// What draws the pictures of captures, with these overlays (see on_surfaces()); `renderer` must outlive it.
Painters painters_of(Renderer &renderer, const Overlays &overlays);

} // namespace sandbox

#pragma once

namespace sandbox {

/// Pixels of a framebuffer, from its lower left corner.
struct PixelRect {
    int x, y, width, height;
};

/// Copies all of `texture` (RGBA8) to `to` in the framebuffer that is drawn into, each pixel as it is, whatever the
/// scissor: cheaper than a textured rectangle. Another size is fitted to `to` by the nearest pixel.
void blit_texture(unsigned texture, const PixelRect &to);

} // namespace sandbox

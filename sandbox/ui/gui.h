#pragma once

#include "ui/session/session.h"

struct GLFWwindow;

namespace sandbox {

/// Dear ImGui in a window: its context, its backends, its fonts and colours.
class Gui {
  public:
    /// `content_scale`: the screen's own magnification. Needs the window's context to be current.
    Gui(GLFWwindow *window, float content_scale);
    ~Gui();
    Gui(const Gui &) = delete;
    Gui &operator=(const Gui &) = delete;

    /// Begins a frame with this theme and scale; loads new fonts if the scale changed.
    void begin_frame(const Appearance &appearance);
    /// Draws the frame into the bound framebuffer.
    void end_frame();

  private:
    void restyle(bool dark, float scale);

    float content_scale_;
    bool dark_ = true;
    float scale_ = 0; ///< of the fonts that are loaded; 0: none yet
};

} // namespace sandbox

#pragma once

#include "ui/host.h"
#include "ui/session/session.h"

namespace sandbox {

/// Dear ImGui: its context, its OpenGL backend, its fonts and colours.
class Gui {
  public:
    /// Needs the host's context to be current.
    explicit Gui(Host &host);
    ~Gui();
    Gui(const Gui &) = delete;
    Gui &operator=(const Gui &) = delete;

    /// Begins a frame with this theme and scale; loads new fonts if the scale changed.
    void begin_frame(const Appearance &appearance);
    /// Draws the frame into the bound framebuffer.
    void end_frame();

  private:
    void restyle(bool dark, float scale);

    Host &host_;
    bool dark_ = true;
    float scale_ = 0; ///< of the fonts that are loaded; 0: none yet
};

} // namespace sandbox

#pragma once

#include "ui/session/session.h"
#include "ui/widgets/fonts.h"

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

    /// Begins a frame that looks as `appearance` says; new fonts where the scale changed.
    void begin_frame(const Appearance &appearance);
    /// Draws it into the framebuffer that is bound.
    void end_frame();
    [[nodiscard]] const Fonts &fonts() const { return fonts_; }

  private:
    void restyle(bool dark, float scale);

    float content_scale_;
    Fonts fonts_;
    bool dark_ = true;
    float scale_ = 0; ///< of the fonts that are loaded; 0: none yet
};

} // namespace sandbox

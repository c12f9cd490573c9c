#pragma once

#include "ui/host.h"
#include "ui/session/session.h"

#include <cstddef>
#include <set>
#include <string>

namespace sandbox {

/// Dear ImGui: its context, its OpenGL backend, its fonts and colours.
class Gui {
  public:
    /// Needs the host's context to be current.
    explicit Gui(Host &host);
    ~Gui();
    Gui(const Gui &) = delete;
    Gui &operator=(const Gui &) = delete;

    /// Begins a frame with this theme and scale; loads new fonts if the scale changed or `rare`, the characters in use
    /// that the text font lacks, has become more, to which what is typed is added. `lesson`: Page up and down, Home and
    /// End go through its steps, and scroll nothing but the list of keys.
    void begin_frame(const Appearance &appearance, bool lesson, const std::set<char32_t> &rare);
    /// Lays the frame out. False if it would show what the last one does; `pictures` counts the changes of the
    /// textures that it shows.
    bool end_frame(unsigned long pictures);
    /// Draws the frame into the bound framebuffer.
    static void draw();

  private:
    void restyle(bool dark, float scale, const std::set<char32_t> &rare);

    Host &host_;
    bool dark_ = true;
    float scale_ = 0;             ///< of the fonts that are loaded; 0: none yet
    std::size_t characters_ = 0;  ///< of those fonts: Chinese ones
    std::string shown_, pending_; ///< the bytes of the draw lists of the last frame and of this one
};

} // namespace sandbox

#pragma once

#include "render/gl_program.h"
#include "render/target.h"
#include "shading/parts.h"

#include <array>

namespace sandbox {

/// The last pass: exposure, transfer curve, clamp; non-finite pixels magenta. The same curve as to_display().
class DisplayPass {
  public:
    explicit DisplayPass(const ShaderParts &parts);
    /// Returns how many pixels of `from` are not finite in red, green or blue. Waits until they are counted.
    unsigned run(const Target &from, DisplayTexture &to, const DisplayMap &map) const;
    /// Signed difference left - right, times gain, in a diverging colour-blind-safe palette (blue: right brighter,
    /// white: equal, orange: left brighter; by the channel that differs most).
    void run_difference(const Target &left, const Target &right, DisplayTexture &to, float gain) const;

  private:
    std::array<GlProgram, 2> display_; ///< by Display
    GlProgram difference_;
    VertexArray empty_;
    Query finite_pixels_;
};

} // namespace sandbox

#pragma once

#include "reference/reference.h"

/// The two ways to see a scene behind one interface: bands of finished rows, and the probe of one pixel.
namespace sandbox::reference {

class Picture {
  public:
    virtual ~Picture() = default;
    [[nodiscard]] virtual std::size_t bands() const = 0;
    /// Draws one band of rows into `frame`, which holds the background. Of a mesh without masks, where `frame` has
    /// none.
    virtual void draw(std::size_t band, ReferenceFrame &frame) const = 0;
    [[nodiscard]] virtual std::optional<PixelProbe> probe(int x, int y) const = 0;
    /// The colours of a row; nothing for the background.
    [[nodiscard]] virtual std::vector<std::optional<glm::dvec3>> row(int y) const = 0;
};

} // namespace sandbox::reference

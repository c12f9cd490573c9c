#pragma once

#include "reference/branches.h"
#include "reference/reference.h"

#include <memory>

/// The two ways to see a scene behind one interface: rows of finished pixels, and the probe of one.
namespace sandbox::reference {

class Picture {
  public:
    virtual ~Picture() = default;
    [[nodiscard]] virtual std::size_t bands() const = 0;
    /// Draws one band of rows into `frame`, which holds the background.
    virtual void draw(std::size_t band, ReferenceFrame &frame) const = 0;
    [[nodiscard]] virtual std::optional<PixelProbe> probe(int x, int y) const = 0;
};

std::unique_ptr<Picture> mesh_picture(const Scene &scene, const std::vector<ObjectResources> &resources,
                                      const Technique &technique, Size size);
/// Throws InputError for what has no analytic surface.
std::unique_ptr<Picture> analytic_picture(const Scene &scene, const std::vector<ObjectResources> &resources,
                                          const Technique &technique, Size size);

/// The probe of a place, but for its object, triangle and masks.
PixelProbe probe_place(const Setup &setup, const Material &material, const Place &place, const Sampler &sampler);

} // namespace sandbox::reference

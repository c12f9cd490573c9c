#pragma once

#include "reference/reference.h"
#include "scene/resources.h"
#include "scene/scene.h"
#include "shading/technique.h"

#include <vector>

namespace sandbox {

/// What rounding a scene's positions to float32 does to the truth itself: all objects, then all lights, are moved to
/// and fro along each axis by 2^-22 (four roundings) of how far from the eye they reach. Light that grazes, light from
/// within the surface and slivers thinner than a pixel magnify that; no formula helps. A cosine's own rounding counts
/// too, 2^-21 of what the lights would give to a surface that faced them; and that what is interpolated is colour over
/// distance per pixel, which float32 ends below 2^-126 of.
class Conditioning {
  public:
    Conditioning(const Scene &scene, const std::vector<ObjectResources> &resources, const Technique &technique,
                 const ReferenceFrame &truth);

    /// The largest error of the compared pixels less what rounding explains of it, as a share of the brightest of them;
    /// where all are darker than a rounding of the cosines, of what the lights would give to a surface that faced them.
    [[nodiscard]] double unexplained(const Frame &drawn) const;

    /// Pixels that show another object than the truth does, moved or not.
    [[nodiscard]] std::size_t unexplained_silhouettes(const Frame &drawn) const;

  private:
    void note(const ReferenceFrame &moved);
    void note_cosines(const ReferenceFrame &facing);
    [[nodiscard]] bool compared(std::size_t pixel) const;

    const ReferenceFrame &truth_;
    std::vector<double> change_;     ///< a pixel each: the largest
    double light_ = 0;               ///< the most that a surface which faced the lights would get
    std::vector<bool> another_seen_; ///< a pixel each: does some moved truth show another object?
};

/// No vertex is farther from the eye than that.
double reach_from(const glm::dvec3 &eye, const Object &object, const Mesh &mesh);

/// The same picture from the origin, where a double holds the smallest move.
Scene seen_from_the_origin(Scene scene);

/// Does the technique light by where the world's origin is? Then that would be another picture.
bool reads_the_origin(const Technique &technique);

} // namespace sandbox

#pragma once

#include "reference/lighting.h"

/// The equation at a place on a surface, and where it jumps: a gate, a hard cone, N turned to the viewer. There a
/// rounding of float32 may take the other branch, with a large difference that is nobody's error.
namespace sandbox::reference {

/// Which terms are worked out at a place (hybrid splits them).
enum class Terms { all, body, highlight };

/// The vectors that the equation is evaluated with at one place.
struct Place {
    glm::dvec3 position{0}; ///< as lit, from the eye
    glm::dvec3 raw_normal{0};
    double normal_length = 1; ///< of raw_normal as interpolated: float32 rounds it by a share of 1, not of this
    glm::dvec3 normal{0};     ///< raw_normal, turned to the viewer if the object is two-sided
    glm::dvec3 view{0};
    glm::dvec3 weights{0}; ///< of a triangle's corners, if it is on one
};

/// A surface around one place.
class Sampler {
  public:
    virtual ~Sampler() = default;
    /// The place that is seen (dx, dy) pixels away from this one; the same one if the surface is only a point.
    [[nodiscard]] virtual Place at(double dx, double dy) const = 0;
    /// The vectors of one light (an index into Setup::lights) at one of those places.
    [[nodiscard]] virtual LightVectors vectors(const Place &place, std::size_t light) const = 0;
};

/// A place by itself: a vertex, a triangle's centroid.
class Point : public Sampler {
  public:
    Point(const Setup &setup, bool two_sided, const glm::dvec3 &position, const glm::dvec3 &normal);
    [[nodiscard]] Place at(double dx, double dy) const override;
    [[nodiscard]] LightVectors vectors(const Place &place, std::size_t light) const override;

  private:
    const Setup &setup_;
    Place place_;
};

/// Is a light so near to `position` (both from the eye) that rounding alone says in which direction it lies?
bool direction_is_rounding(const LightSetup &light, const glm::dvec3 &position);

/// The sum over all lights.
Reflected reflect(const Setup &setup, const Material &material, Terms terms, const Place &place,
                  const Sampler &sampler);

/// Could the colour at `here` jump? Yes if a branch that matters (by more than 1e-6 of linear colour) is taken where
/// the quantity that it tests is zero to within its own change over edge_width of a pixel plus its float32 rounding: 8
/// units in the last place of 1, and of the positions it is a difference of (as shares of the distance).
bool may_jump(const Setup &setup, const Material &material, bool two_sided, Terms terms, const Place &here,
              const Sampler &sampler);

} // namespace sandbox::reference

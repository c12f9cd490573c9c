#pragma once

#include "reference/lighting.h"

#include <numbers>

/// The equation at a point of a surface, and where it jumps: a gate, a hard cone, N turned to the viewer. There a
/// rounding of float32 may take the other branch: a large difference, but no error.
namespace sandbox::reference {

/// What float32 may lose of a quantity near 1: 8 units in the last place.
constexpr double rounding = 8 * 0x1p-24;

/// Which terms are worked out at a point (hybrid splits them).
enum class Terms { all, body, highlight };

/// The vectors that the equation is evaluated with at one point.
struct SurfacePoint {
    glm::dvec3 position{0}; ///< as lit, from the eye
    glm::dvec3 raw_normal{0};
    /// Of the interpolated normal, before it was made unit; its float32 rounding is a share of 1, not of this. One over
    /// N's length where nothing makes it unit: then the rounding is a share of that length.
    double normal_length = 1;
    glm::dvec3 normal{0}; ///< raw_normal, turned where facing() says so
    glm::dvec3 view{0};
    double view_length = 1; ///< of an interpolated V, before it was made unit
    glm::dvec3 weights{0};  ///< of a triangle's corners, if it is on one
};

/// The terms of an interpolation's sums, which cancel to what is left at a point: float32 rounds those.
struct InterpolationTerms {
    double weights = 1;   ///< weights_before_cancelling()
    double positions = 0; ///< the corners' distances from the point, at most, times that
};

/// Every intermediate of one light at one point.
struct LightProbe {
    std::size_t light = 0; ///< in scene.lights
    LightTerms terms;
};

/// By how much the colour at a point may differ for reasons that are nobody's error, at most.
struct Doubts {
    /// The equation takes another branch (a gate, a hard cone, N turned to the viewer) within edge_width, or where the
    /// quantity that decides is zero to within its float32 `rounding` and that of the positions it is a difference of.
    Reflected jump;
    /// float32 keeps too little of a direction: of that to a light, or of a normal or another interpolated vector that
    /// nearly cancels.
    Reflected rounding;
};
Doubts &operator+=(Doubts &sum, const Doubts &more);
Doubts operator*(double weight, const Doubts &doubts);

/// Why a pixel is left out of error figures.
struct PixelMasks {
    bool jump = false, rounding = false;
    double doubt = 0; ///< by how much a channel of the colour may differ, at most
};

/// All directions to within `angle` (radians) of a unit one; at pi all there are.
struct Directions {
    glm::dvec3 axis{0, 0, 1};
    double angle = std::numbers::pi;
};
/// Those to the points of a ball around `middle`.
Directions directions_to(const glm::dvec3 &middle, double radius);

/// An object's surface around one point. Keeps references to the setup and the object.
class Sampler {
  public:
    Sampler(const Setup &setup, const Object &object) : setup_(setup), object_(object) {}
    virtual ~Sampler() = default;
    /// The point that is seen (dx, dy) pixels away from this one; the same one if the surface is only a point.
    [[nodiscard]] virtual SurfacePoint point_at(double dx, double dy) const = 0;
    /// The vectors of one light (an index into Setup::lights) at one of those points; exact unless overridden.
    [[nodiscard]] virtual LightVectors vectors(const SurfacePoint &point, std::size_t light) const;
    /// Of the point itself; as if nothing cancels where nothing is interpolated.
    [[nodiscard]] virtual InterpolationTerms interpolation_terms() const { return {}; }

    /// The sum over all lights at one of those points.
    [[nodiscard]] Reflected reflect(Terms terms, const SurfacePoint &point) const;
    [[nodiscard]] std::vector<LightProbe> probe_lights(const SurfacePoint &point) const;
    [[nodiscard]] Doubts doubts(Terms terms, const SurfacePoint &here) const;
    /// Which doubts show where the surface's own colour is `base`: a jump by more than 1e-6 of linear colour, a
    /// rounding by more than 1e-5.
    [[nodiscard]] PixelMasks masks(const Doubts &doubts, const glm::dvec3 &base) const;
    /// The same at a border between a checker's cells, where the surface's own colour, too, jumps, in this light.
    [[nodiscard]] PixelMasks border_masks(const Doubts &doubts, const Checker &checker,
                                          const Reflected &reflected) const;

  protected:
    [[nodiscard]] bool keeps_normal_lengths() const { return setup_.technique.normals == Normals::unnormalized; }
    /// The point at `position` (as lit, from the eye) with the unit normal before it is turned.
    [[nodiscard]] SurfacePoint surface_point(const glm::dvec3 &position, const glm::dvec3 &normal, Side side) const;
    [[nodiscard]] LightTerms terms_at(const SurfacePoint &point, std::size_t light) const;
    /// What is in doubt at `here` if the direction to the light may be any of these, and R's or H's any of those.
    [[nodiscard]] Reflected doubt_of_direction(Terms terms, const SurfacePoint &here, std::size_t light,
                                               const Directions &to_light, const Directions &highlight) const;

    const Setup &setup_;
    const Object &object_;
    friend class Branches;
};

/// A point without a surface around it: a vertex, a triangle's centroid.
class IsolatedPoint : public Sampler {
  public:
    IsolatedPoint(const Setup &setup, const Object &object, const glm::dvec3 &position, const glm::dvec3 &normal,
                  Side side)
        : Sampler(setup, object), point_(surface_point(position, normal, side)) {}
    [[nodiscard]] SurfacePoint point_at(double, double) const override { return point_; }

  private:
    SurfacePoint point_;
};

/// Is a light so near to `position` (both from the eye) that rounding alone says in which direction it lies?
bool direction_is_rounding(const Setup &setup, const LightSetup &light, const glm::dvec3 &position);
/// Where the light then is, as seen from `position`: a ball around so much of the unit vector, of this radius.
struct LostDirection {
    double length, radius;
};
LostDirection lost_direction(const Setup &setup, const LightSetup &light, const glm::dvec3 &position);

} // namespace sandbox::reference

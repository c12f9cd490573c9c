#pragma once

#include "reference/medium_stage.h"
#include "reference/mesh_scene.h"

/// One pixel of a mesh: what the technique's frequency makes of the triangle it sees.
namespace sandbox::reference {

/// The triangle around a pixel's centre (x, y), in pixels from the top-left corner. Interpolates positions, normals
/// and, where the technique asks for it, the lights' vectors; all perspective-correct.
class Fragment : public Sampler {
  public:
    Fragment(const MeshScene &scene, const Hit &hit, double x, double y);

    [[nodiscard]] SurfacePoint point_at(double dx, double dy) const override;
    [[nodiscard]] LightVectors vectors(const SurfacePoint &point, std::size_t light) const override;
    [[nodiscard]] InterpolationTerms interpolation_terms() const override;

    [[nodiscard]] glm::dvec3 color() const;
    /// The texture's or checker's colour here, times that of the vertices.
    [[nodiscard]] glm::dvec3 base() const;
    /// Could the colour differ for reasons that are nobody's error?
    [[nodiscard]] PixelMasks masks() const;
    /// Does the centre lie within edge_width of an edge of its triangle?
    [[nodiscard]] bool at_edge() const;
    /// Where the equation is evaluated for this pixel: here, or at the triangle's centroid under flat.
    [[nodiscard]] SurfacePoint evaluated_point() const;

  private:
    [[nodiscard]] glm::dvec3 weights(double dx, double dy) const;
    [[nodiscard]] SurfacePoint corner(int i) const;
    /// Of the light that was found at the corners.
    [[nodiscard]] glm::dvec3 interpolated_light(glm::dvec3 Reflected::*part) const;
    [[nodiscard]] Reflected reflected() const;
    [[nodiscard]] bool at_cell_border() const;
    [[nodiscard]] Doubts corner_doubts() const;
    [[nodiscard]] Doubts doubts() const;
    [[nodiscard]] glm::dvec3 object_position(const glm::dvec3 &weights) const;
    /// As interpolation leaves them: L, R and H not yet unit.
    [[nodiscard]] LightVectors blended_vectors(const SurfacePoint &point, std::size_t light) const;
    [[nodiscard]] LightVectors interpolated_vectors(const SurfacePoint &point, std::size_t light) const;
    [[nodiscard]] Varyings varyings() const;

    const MeshObject &mesh_;
    Triangle on_screen_;
    std::size_t triangle_index_;
    Frequency frequency_; ///< of this triangle
    glm::uvec3 triangle_;
    Side side_;
    const Lit &lit_;
    double x_, y_;
    SurfacePoint here_;
};

} // namespace sandbox::reference

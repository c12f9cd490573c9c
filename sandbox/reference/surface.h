#pragma once

#include "image/image.h"
#include "reference/lighting.h"
#include "scene/resources.h"
#include "scene/scene.h"

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

/// What a surface brings to the equation: where it is, which way it faces and its own colour.
namespace sandbox::reference {

/// The matrix that `normals` names: sign(det A) cofactor(A) (sign(0) = +1), with or without the sign, A itself, or 1.
/// Scaled to avoid overflow, but for normals=unnormalized.
glm::dmat3 normal_matrix(const glm::dmat3 &linear, Normals normals);

/// unit(matrix * n); n itself where that is 0 (a surface flattened to a line has no normal of its own).
glm::dvec3 transform_normal(const glm::dmat3 &matrix, const glm::dvec3 &n);

/// Object space to where the camera and the equation see it.
struct WorldTransform {
    glm::dmat3 linear{1};
    glm::dvec3 offset{0};     ///< seen at linear * p + offset, from the eye
    glm::dvec3 lit_offset{0}; ///< lit at linear * p + lit_offset: the same, but for position=w0 (no translation)
    glm::dmat3 normals{1};
    bool unnormalized = false;       ///< normals keep the length that the matrix gives them
    bool absolute = false;           ///< lit where float32 world coordinates put it
    glm::dvec3 translate{0}, eye{0}; ///< world space

    [[nodiscard]] glm::dvec3 normal(const glm::dvec3 &n) const {
        return unnormalized ? normals * n : transform_normal(normals, n);
    }
    [[nodiscard]] glm::dvec3 seen(const glm::dvec3 &p) const { return linear * p + offset; }
    [[nodiscard]] glm::dvec3 lit(const glm::dvec3 &p) const {
        return absolute ? as_float(linear * p + translate) - as_float(eye) : linear * p + lit_offset;
    }
};
WorldTransform world_transform(const Transform &transform, const Setup &setup);

/// Bilinear, repeat; texel centres at (i + 0.5) / size, v = 0 at the bottom row (rows are stored from the top).
glm::dvec3 sample_texture(const Image &image, const glm::dvec2 &uv);

/// A checker's cell coordinates at p: x * cells / (2 R) + cells / 2 in each axis. The centre plane is exact in any
/// precision, and cells end at the bounding cube, so that a box's faces lie in the outermost cells.
glm::dvec3 checker_coordinates(const Checker &checker, double half_extent, const glm::dvec3 &p);
glm::dvec3 checker_color(const Checker &checker, double half_extent, const glm::dvec3 &p);

/// `base`: the texture's or the checker's colour at a point, or 1.
struct BaseColor {
    const Image *texture = nullptr;
    const Checker *checker = nullptr;
    double half_extent = 1;

    [[nodiscard]] glm::dvec3 color_at(const glm::dvec2 &uv, const glm::dvec3 &object_position) const;
    [[nodiscard]] bool has_cells() const; ///< of two different colours
    /// Does an edge of a checker's cells pass between the object positions `here`, `right` and `below`, or within
    /// `rounding` (of each cell coordinate) of them?
    [[nodiscard]] bool cell_may_change(const glm::dvec3 &here, const glm::dvec3 &right, const glm::dvec3 &below,
                                       const glm::dvec3 &rounding) const;
};
BaseColor base_color(const Object &object, const ObjectResources &resources);

} // namespace sandbox::reference

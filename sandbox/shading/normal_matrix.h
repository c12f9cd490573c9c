#pragma once

#include <glm/mat3x3.hpp>

namespace sandbox {

/// The inverse transpose of `linear` up to a positive factor: sign(det) * cofactor matrix (sign(0) = +1), which exists
/// for singular matrices too, scaled so that its largest element is 1 (normals are made unit after it).
glm::dmat3 normal_matrix(const glm::dmat3 &linear);

} // namespace sandbox

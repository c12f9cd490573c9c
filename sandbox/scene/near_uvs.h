#pragma once

#include "scene/mesh.h"

#include <memory>

/// Texture coordinates far from 0 leave float32 no digits for where in the texture they are: none of a 256-texel
/// texture at 100,000. Textures repeat, so whole numbers may be taken off, in double, before a coordinate becomes a
/// float.
namespace sandbox {

/// What is taken off is a multiple of this, so that neighbours mostly agree and share their vertices.
constexpr double uv_step = 16;

/// The mesh with the coordinates of every triangle moved by multiples of `step` until the middle of their range lies
/// within step / 2 of 0; a vertex whose triangles move by different amounts is split. The very same mesh if no
/// triangle moves. Not normalised away is a triangle's own span: over S repeats float32 places a texel to about
/// (S + step) * 2^-21 repeats (3e-4 * width texels at S = 600). `step` must be a whole number.
std::shared_ptr<const Mesh> with_near_uvs(const std::shared_ptr<const Mesh> &mesh, double step = uv_step);

/// The mesh with its coordinates times `repeat`, each triangle's then within one repeat of 0 as far as its span allows.
std::shared_ptr<const Mesh> with_repeated_uvs(const std::shared_ptr<const Mesh> &mesh, const glm::dvec2 &repeat);

} // namespace sandbox

#pragma once

#include "scene/mesh.h"
#include "scene/resources.h"
#include "scene/scene.h"

#include <vector>

namespace sandbox {

/// The power of two that every length of a draw is multiplied by, so that squares of lengths stay within float32: 1
/// wherever they do anyhow, which is between 1e-16 and 1e16 world units from the eye.
double length_scale(const Scene &scene, const Object &object, const Mesh &mesh);

/// far / near from which a float32 depth buffer no longer tells surfaces apart by z / w (its step at `far` is then a
/// tenth of the distance): the logarithm of the distance is stored instead, by all objects or none. So far off a vertex
/// beyond `far` loses the same digits of z, and takes them from all of its triangle.
constexpr double deep_range = 1e6;
bool is_deep(const Camera &camera);
bool is_deep(const Scene &scene, const std::vector<ObjectResources> &resources);

/// Is the object so much larger than its distance (1e4 times) that positions interpolated over it lose the digits that
/// count near the eye? They are found from the pixel and the depth instead.
bool is_wide(const Scene &scene, const Object &object, const Mesh &mesh);

} // namespace sandbox

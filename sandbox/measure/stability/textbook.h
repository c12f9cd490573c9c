#pragma once

#include "image/image.h"
#include "scene/resources.h"
#include "scene/scene.h"
#include "shading/technique.h"

#include <vector>

namespace sandbox {

/// A textbook's equation in float32, per pixel or per vertex, on the CPU, as people write it: world-space positions,
/// inverse() of the model matrix, normals as the file gives them and not turned where a back is seen, normalize without
/// a guard, 1 / (kc + kl d + kq d^2), exp2(n log2 f), a cone by smoothstep whatever its angles, a float32 depth buffer
/// in which depth falls off as near / w. Of `technique` it takes the model, and whether it is per vertex; textures are
/// left out. Which of one side's triangles a pixel sees comes from the reference.
Frame textbook_picture(const Scene &scene, const std::vector<ObjectResources> &resources, const Technique &technique,
                       Size size);

} // namespace sandbox

#pragma once

#include "image/image.h"
#include "scene/resources.h"
#include "scene/scene.h"
#include "shading/technique.h"

#include <vector>

namespace sandbox {

/// A textbook's equation in float32, per pixel, on the CPU: world-space positions, inverse() of the model matrix,
/// normalize without a guard, 1 / (kc + kl d + kq d^2), exp2(n log2 f), a cone by a clamped quotient. `technique` gives
/// the model alone. Visibility comes from the reference; only the shading is float32.
Frame textbook_picture(const Scene &scene, const std::vector<ObjectResources> &resources, const Technique &technique,
                       Size size);

} // namespace sandbox

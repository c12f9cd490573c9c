#pragma once

#include "scene/resources.h"
#include "shading/technique.h"

#include <vector>

namespace sandbox {

/// The resources as drawn by `technique`: where a view is so narrow that it sees less than a 64th of an object, the
/// mesh is cut down, in double, to what lies near the view. Float32 interpolation over the whole of a triangle would
/// lose the digits that such a view magnifies. The picture is the same but for rounding, which is why only techniques
/// that interpolate nothing but positions and unit normals are cut. `aspect`: width over height.
std::vector<ObjectResources> seen_parts(const Scene &scene, const Technique &technique,
                                        std::vector<ObjectResources> resources, double aspect);

} // namespace sandbox

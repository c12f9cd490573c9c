#pragma once

#include "reference/reference.h"
#include "scene/resources.h"
#include "scene/scene.h"
#include "shading/technique.h"

#include <vector>

namespace sandbox {

/// Proves masks by the truth alone, without what the reference knows of branches: the picture is moved by
/// reference::edge_width, lights against objects, directions and normals by two reference::rounding, one way at a time,
/// cones are made wider, and lights may end up in any direction. True where the truth then changes by more than
/// `negligible`: float32, which may round that way, may draw either. Stops once all
/// but `few` of the `asked` pixels are proved.
std::vector<bool> owed_pixels(const Scene &scene, const std::vector<ObjectResources> &resources,
                              const Technique &technique, const ReferenceFrame &truth, double negligible,
                              const std::vector<bool> &asked, std::size_t few);

} // namespace sandbox

#pragma once

#include "reference/picture.h"

#include <memory>

namespace sandbox::reference {

/// The triangles that OpenGL gets. `scene` and `resources` must outlive the picture. `high`: as in Setup.
std::unique_ptr<Picture> mesh_picture(const Scene &scene, const std::vector<ObjectResources> &resources,
                                      const Technique &technique, Size size, const HighValues &high = {});

} // namespace sandbox::reference

#pragma once

#include "reference/picture.h"

#include <memory>

namespace sandbox::reference {

/// The shapes themselves. `scene` and `resources` must outlive the picture. Throws InputError for what has no analytic
/// surface: an OBJ, an object flattened by a scale of 0, a technique that needs vertices.
std::unique_ptr<Picture> analytic_picture(const Scene &scene, const std::vector<ObjectResources> &resources,
                                          const Technique &technique, Size size);

} // namespace sandbox::reference

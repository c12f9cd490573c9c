#pragma once

#include "scene/scene.h"

#include <functional>

namespace sandbox {

/// A smaller scene on which `fails` is still true, as `scene` is: lights, objects and keys are dropped from its JSON,
/// numbers made round, as long as the result can be read and still fails. `fails` is asked some hundred times.
Scene shrunk(const Scene &scene, const std::function<bool(const Scene &)> &fails);

} // namespace sandbox

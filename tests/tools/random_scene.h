#pragma once

#include "scene/scene.h"
#include "shading/technique.h"

namespace sandbox {

/// A small scene of everything that there is (every shape, light, material switch and transform), by its seed alone.
Scene random_scene(unsigned seed);

/// A valid technique with any values of any keys, by its seed alone.
Technique random_technique(unsigned seed);

} // namespace sandbox

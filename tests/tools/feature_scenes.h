#pragma once

#include "scene/mesh.h"
#include "scene/scene.h"

#include <string>
#include <vector>

namespace sandbox {

/// Small one-object scenes that need different things of a program: each light type plain and with all it can have,
/// none, several, textured, chequered, two-sided, emitting, squashed.
std::vector<Scene> feature_scenes();

} // namespace sandbox

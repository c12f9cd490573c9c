#pragma once

#include "scene/scene.h"
#include "shading/technique.h"

#include <cstdint>
#include <vector>

namespace sandbox {

/// A valid scene of extreme numbers and the techniques to draw it with. `family` (any number; stress_families differ)
/// fixes what the programs hold: techniques, kinds of lights and their terms, the material's; `seed` draws the numbers,
/// from all that a scene file may say. The same two give the same scene everywhere.
struct StressScene {
    Scene scene;
    std::vector<Technique> techniques; ///< stress_techniques of them
};
constexpr std::uint32_t stress_families = 25;
constexpr std::uint32_t stress_techniques = 3; ///< so that there are 75 sets of features, and some guards
StressScene stress_scene(std::uint32_t family, std::uint32_t seed);

} // namespace sandbox

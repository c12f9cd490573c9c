#pragma once

#include "scene/scene.h"
#include "shading/technique.h"

#include <cstdint>

namespace sandbox {

/// A valid scene of extreme numbers and the technique to draw it with. `family` (any number; 60 differ) fixes what the
/// program holds: frequency, model, kinds of lights and their terms; `seed` draws the numbers. The same two give the
/// same scene everywhere.
struct StressScene {
    Scene scene;
    Technique technique;
};
constexpr std::uint32_t stress_families = 60;
StressScene stress_scene(std::uint32_t family, std::uint32_t seed);

} // namespace sandbox

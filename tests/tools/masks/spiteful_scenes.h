#pragma once

#include "scene/scene.h"
#include "shading/technique.h"

#include <optional>

namespace sandbox {

/// A scene and a technique that tempt a mask to cover too much or too little: lights on vertices, black lights, hard
/// cones, steep highlights, cells of one colour, surfaces that coincide, deep and far cameras. By its seed alone.
struct SpitefulScene {
    Scene scene;
    Technique technique;
};
SpitefulScene spiteful_scene(unsigned seed);

/// One other fault than those that `technique` has, valid beside them and able to change the scene's picture; nothing
/// where there is none.
std::optional<Technique> with_a_fault(const Scene &scene, const Technique &technique, unsigned seed);

} // namespace sandbox

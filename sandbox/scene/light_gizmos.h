#pragma once

#include "scene/scene.h"

#include <cstddef>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

/// Where lights lie in a view, and what a drag there does to them. Places are shares of the view's width and height,
/// from its upper left corner; `aspect` is width / height.
namespace sandbox {

/// What can be dragged: the lamp or the tail of a directional light's arrow, and the tip of a spot's axis.
enum class LightHandle { lamp, tip };

struct LightGizmo {
    std::size_t light = 0;                      ///< of the scene
    glm::dvec2 lamp{0};                         ///< in the picture
    std::optional<glm::dvec2> from, to;         ///< an arrow, the way the light travels; of a point light none
    bool turns = false;                         ///< `to` is a handle
    std::vector<std::vector<glm::dvec2>> lines; ///< of a cone: its outline, its circle and, if soft, the inner circle
};

/// Of every light that is on and whose lamp or tail is in the picture. A directional light's arrow ends before the
/// camera's target, at which it points.
std::vector<LightGizmo> light_gizmos(const Scene &scene, double aspect);

/// The light after its handle has been dragged by shares of the view. A lamp moves in the plane through it that is
/// parallel to the picture, and keeps its direction. A tip or tail turns the light: it runs on a ball about the lamp or
/// the camera's target, under the mouse, and beyond the ball's outline comes back on its far side. The direction keeps
/// its length. What would leave the world stays where it is.
Light dragged_light(const Scene &scene, std::size_t light, LightHandle handle, double aspect, const glm::dvec2 &by);

} // namespace sandbox

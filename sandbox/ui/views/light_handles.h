#pragma once

#include "ui/session/session.h"
#include "ui/views/view_mouse.h"

#include <optional>

/// The lights over a picture, and dragging them.
namespace sandbox {

/// Draws them if they are switched on. Scripts call their handles "light 2" and "light 2 tip".
void draw_lights(Session &session, const Rect &picture);

/// The handle under the mouse, if lights are switched on.
std::optional<LightDrag> light_under_mouse(const Session &session, const Rect &picture);
/// Moves the light of session.view.light_drag to where the mouse is now.
void drag_light(Session &session, const Rect &picture);

} // namespace sandbox

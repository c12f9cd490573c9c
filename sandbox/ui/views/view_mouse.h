#pragma once

#include "ui/session/session.h"

#include <imgui.h>
#include <string>

namespace sandbox {

/// In ImGui's screen coordinates, y down.
struct Rect {
    ImVec2 low, high;
    [[nodiscard]] float width() const { return high.x - low.x; }
    [[nodiscard]] float height() const { return high.y - low.y; }
};

/// Where a wipe changes from A to B.
float divider_x(const Session &session, const Rect &picture);

/// The mouse over one picture: orbit, pan, dolly, the wipe's divider, reset. All pictures have the same camera. Scripts
/// call it `name`/picture.
void mouse_over_picture(Session &session, const Rect &picture, const std::string &name);

} // namespace sandbox

#pragma once

#include "ui/session/session.h"

#include <imgui.h>

namespace sandbox {

/// In ImGui's screen coordinates, y down.
struct Rect {
    ImVec2 low, high;
    [[nodiscard]] float width() const { return high.x - low.x; }
    [[nodiscard]] float height() const { return high.y - low.y; }
};

/// Where a wipe changes from A to B.
float divider_x(const Session &session, const Rect &picture);

/// The mouse over one picture: orbit, pan, dolly, the wipe's divider, reset. The cameras are one camera, so it does not
/// matter which picture it is.
void mouse_over_picture(Session &session, const Rect &picture, int id);

} // namespace sandbox

#pragma once

#include "ui/session/session.h"
#include "ui/tabs/bottom_panel.h"
#include "ui/views/view_painter.h"

namespace sandbox {

/// Draws everything inside the window once: panels edit the session, pictures are updated.
void draw_frame(Session &session, ViewPainter &painter, BottomPanel &bottom);

void menu_bar(Session &session);
/// The bottom line: a hint about what the mouse is over, else the last message. `height` in ImGui's units.
void status_line(Session &session, float height);

} // namespace sandbox

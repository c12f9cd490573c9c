#pragma once

#include "ui/session/session.h"
#include "ui/tabs/bottom_panel.h"
#include "ui/views/view_painter.h"

namespace sandbox {

/// Draws everything inside the window once: panels edit the session, pictures are updated.
void draw_frame(Session &session, ViewPainter &painter, BottomPanel &bottom);

} // namespace sandbox

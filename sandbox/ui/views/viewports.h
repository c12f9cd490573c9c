#pragma once

#include "ui/session/session.h"
#include "ui/views/view_painter.h"

namespace sandbox {

/// Fills the current ImGui window with the pictures: camera and divider by mouse, names above, times below.
void viewports(Session &session, ViewPainter &painter);

} // namespace sandbox

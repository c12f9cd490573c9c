#pragma once

#include "ui/session/session.h"
#include "ui/views/view_mouse.h"
#include "ui/views/view_painter.h"

namespace sandbox {

/// Height of the scale and its controls below a difference picture, in ImGui's units.
float difference_scale_height();

/// Below a difference picture: a scale for its colours, the gain, the largest difference.
void difference_scale(Session &session, const ViewPainter &painter, const Rect &picture);

} // namespace sandbox

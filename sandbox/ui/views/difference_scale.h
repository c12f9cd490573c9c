#pragma once

#include "ui/views/view_mouse.h"
#include "ui/views/view_painter.h"

namespace sandbox {

/// In the foot of a picture of a difference: the colours, numbers, which side is the brighter.
void difference_scale(const Session &session, const Rect &picture);
/// Below the picture: the difference of what, its gain, the largest.
void difference_controls(Session &session, const ViewPainter &painter, const Rect &picture);

} // namespace sandbox

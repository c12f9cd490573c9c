#pragma once

#include "ui/fonts.h"
#include "ui/session.h"
#include "ui/view_painter.h"

namespace sandbox {

/// The programs of A and B for the shown object, beside each other, in the current ImGui window. Lines that the other
/// side lacks are marked in the side's colour, lines that stand in its other stage ("moved") with an arrow.
void glsl_panel(Session &session, ViewPainter &painter, const Fonts &fonts);

} // namespace sandbox

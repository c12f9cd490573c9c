#pragma once

#include "ui/session/session.h"

namespace sandbox {

/// All sections, in the current ImGui window.
void side_panel(Session &session);

/// The choice of the object that Material and Mesh show, if there are several; false if there is none.
bool object_choice(Session &session);

} // namespace sandbox

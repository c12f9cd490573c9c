#pragma once

#include "ui/session/session.h"

/// Sections of the side panel, one file each; side_panel.cpp lists them.
namespace sandbox {

void lights_panel(Session &session);
void material_panel(Session &session);
void mesh_panel(Session &session);
void camera_panel(Session &session);

} // namespace sandbox

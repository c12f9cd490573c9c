#pragma once

#include "ui/session/session.h"

/// The sections of the side panel, one file each; side_panel.cpp lists them.
namespace sandbox {

void technique_panel(Session &session);
void faults_panel(Session &session);
void lights_panel(Session &session);
void material_panel(Session &session);
void mesh_panel(Session &session);
void camera_panel(Session &session);

/// All of them below each other, in the current ImGui window.
void side_panel(Session &session);

} // namespace sandbox

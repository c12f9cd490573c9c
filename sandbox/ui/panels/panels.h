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

/// All sections, in the current ImGui window.
void side_panel(Session &session);

/// The choice of the object that Material and Mesh show, if there are several; false if there is none.
bool object_choice(Session &session);

} // namespace sandbox

#include "ui/panels/panels.h"
#include "ui/session/edits.h"
#include "ui/views/orbit.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <imgui.h>

namespace sandbox {

namespace {

void view_button(Session &session, const char *name, const Camera &camera, bool first) {
    if (!first) {
        same_line_if_fits(ImGui::CalcTextSize(name).x + ImGui::GetStyle().FramePadding.x * 2);
    }
    if (toggle_button(name, session.document.scene.camera == camera)) {
        session.document.scene.camera = camera;
    }
    hint_for_item(session, "Look from here.");
}

void named_views(Session &session) {
    view_button(session, "as opened", session.document.opened->scene.camera, true);
    int id = 0;
    for (const View &view : session.document.scene.views) {
        ImGui::PushID(id++);
        view_button(session, view.name.c_str(), view.camera, false);
        ImGui::PopID();
    }
}

void orbit_rows(Session &session) {
    Camera &camera = session.document.scene.camera;
    const OrbitPose opened = orbit_pose(session.document.opened->scene.camera);
    OrbitPose pose = orbit_pose(camera);
    bool changed = slider_row(session, "azimuth, degrees", pose.azimuth_degrees, opened.azimuth_degrees,
                              ranges::angle_degrees, "Around the target; drag the picture to orbit");
    changed |= slider_row(session, "elevation, degrees", pose.elevation_degrees, opened.elevation_degrees,
                          ranges::elevation_degrees, "Above the target; drag the picture to orbit");
    changed |= slider_row(session, "distance, units", pose.distance, opened.distance, ranges::distance,
                          "From the target; the wheel over the picture comes closer or goes away");
    if (changed) {
        camera = at_pose(camera, pose);
    }
}

void display_choice(Session &session) {
    Display &display = session.document.display;
    row_label("display");
    if (ImGui::RadioButton("linear", display == Display::linear)) {
        display = Display::linear;
    }
    hint_for_item(session, "Shows the numbers as they are, as the classic lighting programs do.");
    ImGui::SameLine();
    if (ImGui::RadioButton("sRGB", display == Display::srgb)) {
        display = Display::srgb;
    }
    hint_for_item(session, "Encodes for the screen, so that twice the light looks like twice the light.");
}

} // namespace

void camera_panel(Session &session) {
    Scene &scene = session.document.scene;
    const Scene &opened = session.document.opened->scene;
    named_views(session);
    orbit_rows(session);
    slider_row(session, "view, degrees", scene.camera.fov_y_degrees, opened.camera.fov_y_degrees, ranges::fov_y_degrees,
               "Vertical angle of view; narrow pictures are widened, so that their sides are not cut off");
    heading("Display");
    slider_row(session, "exposure", session.document.exposure, 1, ranges::exposure,
               "Multiplies the picture before it is shown; measurements never see it");
    display_choice(session);
    color_row(session, "background", scene.background, opened.background, "Where there is no object");
}

} // namespace sandbox

#include "scene/orbit.h"
#include "ui/panels/panels.h"
#include "ui/widgets/property_rows.h"

#include <imgui.h>
#include <string>
#include <vector>

namespace sandbox {

namespace {

constexpr Range elevation{.low = -most_elevation_degrees,
                          .high = most_elevation_degrees,
                          .slider = {-most_elevation_degrees, most_elevation_degrees, "%.1f"}};
constexpr Range distance_range{.low = 1e-6, .high = 1e9, .slider = {0.5, 50, "%.2f", true}};
constexpr Range exposure_range{.low = 0, .high = 1e6, .slider = {0.05, 20, "%.3g", true}};

void view_button(Session &session, const std::string &name, const Camera &camera) {
    if (toggle_button(session, name, session.document.scene.camera == camera, "Look from here.")) {
        session.document.scene.camera = camera;
    }
}

void named_views(Session &session) {
    view_button(session, "as opened", session.document.opened->scene.camera);
    for (std::size_t i = 0; i < session.document.scene.views.size(); ++i) {
        const View view = session.document.scene.views[i];
        const ScopedId id(i);
        same_line_if_fits(button_width(view.name));
        view_button(session, view.name, view.camera);
    }
}

void orbit_rows(Session &session) {
    Camera &camera = session.document.scene.camera;
    const OrbitPose opened = orbit_pose(session.document.opened->scene.camera);
    OrbitPose pose = orbit_pose(camera);
    bool changed = control_row(session, {"azimuth, degrees", rotation, "Around the target; drag the picture to orbit."},
                               pose.azimuth_degrees, opened.azimuth_degrees);
    changed |= control_row(session, {"elevation, degrees", elevation, "Above the target; drag the picture to orbit."},
                           pose.elevation_degrees, opened.elevation_degrees);
    changed |= control_row(session,
                           {"distance, units", distance_range,
                            "To the target; the wheel over the picture moves a perspective camera closer or away."},
                           pose.distance, opened.distance);
    if (changed) {
        camera = at_pose(camera, pose);
    }
}

void projection_choice(Session &session) {
    Camera &camera = session.document.scene.camera;
    const std::vector<std::string> names(words_of<Projection>.begin(), words_of<Projection>.end());
    auto chosen = static_cast<std::size_t>(camera.projection);
    if (choice_row(session, "projection", names, chosen,
                   "Orthographic: nothing looks smaller far away, and V is the same at every point.")) {
        camera = with_projection(camera, static_cast<Projection>(chosen));
    }
}

void display_choice(Session &session) {
    Display &display = session.document.display;
    row_label("display");
    if (radio_button(session, "linear", display == Display::linear,
                     "Shows the numbers as they are, as the classic lighting programs do.")) {
        display = Display::linear;
    }
    ImGui::SameLine();
    if (radio_button(session, "sRGB", display == Display::srgb,
                     "Encodes for the screen, so that twice the light looks like twice the light.")) {
        display = Display::srgb;
    }
}

} // namespace

void camera_panel(Session &session) {
    named_views(session);
    orbit_rows(session);
    projection_choice(session);
    property_rows(session, session.document.scene.camera, session.document.opened->scene.camera);
    heading("Display");
    control_row(session,
                {"exposure", exposure_range, "Multiplies the picture before it is shown; measurements never see it."},
                session.document.exposure, 1);
    display_choice(session);
}

} // namespace sandbox

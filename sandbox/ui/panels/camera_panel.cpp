#include "capture/picture_ranges.h"
#include "scene/orbit.h"
#include "ui/panels/panels.h"
#include "ui/widgets/property_rows.h"
#include "words/row_words.h"

#include <imgui.h>
#include <string>
#include <vector>

namespace sandbox {

namespace {

constexpr Range elevation{.low = -most_elevation_degrees,
                          .high = most_elevation_degrees,
                          .slider = {-most_elevation_degrees, most_elevation_degrees, "%.1f"}};
constexpr Range distance_range{.low = 1e-6, .high = 1e10, .slider = {0.5, 50, "%.2f", true}};

void view_button(Session &session, const Label &name, const Camera &camera) {
    if (toggle_button(session, name, session.document.scene.camera == camera, session.text("camera.view.help"))) {
        session.document.scene.camera = camera;
    }
}

void named_views(Session &session) {
    view_button(session, session.label("camera.as_opened"), session.document.opened->scene.camera);
    for (std::size_t i = 0; i < session.document.scene.views.size(); ++i) {
        const View view = session.document.scene.views[i];
        const ScopedId id(i);
        const Label name(file_text(session.words, view.name), view.name);
        same_line_if_fits(button_width(name.shown));
        view_button(session, name, view.camera);
    }
}

void orbit_rows(Session &session) {
    Camera &camera = session.document.scene.camera;
    const OrbitPose opened = orbit_pose(session.document.opened->scene.camera);
    OrbitPose pose = orbit_pose(camera);
    bool changed =
        control_row(session, row_of(session, "camera.azimuth", rotation), pose.azimuth_degrees, opened.azimuth_degrees);
    changed |= control_row(session, row_of(session, "camera.elevation", elevation), pose.elevation_degrees,
                           opened.elevation_degrees);
    changed |= control_row(session, row_of(session, "camera.distance", distance_range), pose.distance, opened.distance);
    if (changed) {
        camera = at_pose(camera, pose);
    }
}

void projection_choice(Session &session) {
    Camera &camera = session.document.scene.camera;
    auto chosen = static_cast<std::size_t>(camera.projection);
    if (choice_row(session, session.label("camera.projection"), word_labels<Projection>(session), chosen,
                   session.text("camera.projection.help"))) {
        camera = with_projection(camera, static_cast<Projection>(chosen));
    }
}

void display_choice(Session &session) {
    Display &display = session.document.display;
    row_label(session.text("camera.display"));
    if (radio_button(session, session.label("camera.linear"), display == Display::linear,
                     session.text("camera.linear.help"))) {
        display = Display::linear;
    }
    ImGui::SameLine();
    if (radio_button(session, "sRGB", display == Display::srgb, session.text("camera.srgb.help"))) {
        display = Display::srgb;
    }
}

} // namespace

void camera_panel(Session &session) {
    named_views(session);
    orbit_rows(session);
    projection_choice(session);
    property_rows(session, session.document.scene.camera, session.document.opened->scene.camera);
    heading(session.text("camera.display.title"));
    control_row(session, row_of(session, "camera.exposure", exposure_range), session.document.exposure, 1);
    display_choice(session);
}

} // namespace sandbox

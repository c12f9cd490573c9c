#include "ui/panels/object_choice.h"
#include "ui/panels/panels.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <imgui.h>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace sandbox {

namespace {

void rows(Session &s, SphereShape &shape, const SphereShape &opened) {
    slider_row(s, "rings", shape.rings, opened.rings, ranges::rings, "Bands of latitude");
    slider_row(s, "segments", shape.segments, opened.segments, ranges::segments, "Slices around the axis");
    slider_row(s, "radius, units", shape.radius, opened.radius, ranges::length, "In object space");
}

void rows(Session &s, BoxShape &shape, const BoxShape &opened) {
    slider_row(s, "divisions", shape.divisions, opened.divisions, ranges::box_divisions, "Squares along each edge");
    vector_row(s, "size, units", shape.size, opened.size, ranges::length, "Edges along x, y, z in object space");
}

void rows(Session &s, PlaneShape &shape, const PlaneShape &opened) {
    slider_row(s, "divisions", shape.divisions, opened.divisions, ranges::plane_divisions, "Squares along each edge");
    slider_row(s, "size x, units", shape.size.x, opened.size.x, ranges::length, "In object space");
    slider_row(s, "size z, units", shape.size.y, opened.size.y, ranges::length, "In object space");
}

void rows(Session &s, CylinderShape &shape, const CylinderShape &opened) {
    slider_row(s, "segments", shape.segments, opened.segments, ranges::segments, "Slices around the axis");
    slider_row(s, "rings", shape.rings, opened.rings, ranges::bands, "Bands along the height");
    slider_row(s, "radius, units", shape.radius, opened.radius, ranges::length, "In object space");
    slider_row(s, "height, units", shape.height, opened.height, ranges::length, "In object space");
    switch_row(s, "caps", shape.caps, opened.caps, "Closes the ends");
}

void rows(Session &s, TorusShape &shape, const TorusShape &opened) {
    slider_row(s, "rings", shape.rings, opened.rings, ranges::segments, "Steps around the axis");
    slider_row(s, "segments", shape.segments, opened.segments, ranges::segments, "Steps around the tube");
    slider_row(s, "radius, units", shape.radius, opened.radius, ranges::length, "Axis to the middle of the tube");
    slider_row(s, "tube, units", shape.tube_radius, opened.tube_radius, ranges::length, "Radius of the tube");
}

void rows(Session &, ObjShape &shape, const ObjShape &) { ImGui::TextWrapped("%s", shape.path.c_str()); }

void shape_choice(Session &session, Shape &shape, const Shape &opened) {
    std::vector<std::string> names{"sphere", "box", "plane", "cylinder", "torus"};
    if (std::holds_alternative<ObjShape>(opened)) {
        names.emplace_back("model file");
    }
    static const std::vector<Shape> fresh{SphereShape{}, BoxShape{}, PlaneShape{}, CylinderShape{}, TorusShape{}};
    std::size_t chosen = shape.index();
    if (choice_row(session, "shape", names, chosen, "What the object is made of")) {
        shape = chosen == opened.index() ? opened : fresh[chosen];
    }
}

void transform_rows(Session &session, Transform &transform, const Transform &opened) {
    heading("Placement");
    vector_row(session, "move, units", transform.translate, opened.translate, ranges::coordinate,
               "World space x, y, z; drag sideways");
    vector_row(session, "turn, degrees", transform.rotate_degrees, opened.rotate_degrees, ranges::angle_degrees,
               "About the fixed axes, x first, then y, then z; drag sideways");
    vector_row(session, "scale", transform.scale, opened.scale, ranges::scale,
               "Unequal numbers show which normals are transformed wrongly; drag sideways");
}

} // namespace

void mesh_panel(Session &session) {
    if (!object_choice(session)) {
        return;
    }
    Object &object = session.shown_object();
    const Object opened = session.opened_object();
    shape_choice(session, object.mesh, opened.mesh);
    std::visit(
        [&](auto &shape) {
            using Kind = std::remove_cvref_t<decltype(shape)>;
            const Kind *same_kind = std::get_if<Kind>(&opened.mesh);
            rows(session, shape, same_kind != nullptr ? *same_kind : Kind{});
        },
        object.mesh);
    if (session.object < session.triangles.size()) {
        ImGui::TextColored(quiet_text(), "%zu triangles", session.triangles[session.object]);
    }
    ImGui::Checkbox("wireframe", &session.view.wireframe);
    hint_for_item(session, "Draws the triangles' edges over both pictures (W).");
    transform_rows(session, object.transform, opened.transform);
}

} // namespace sandbox

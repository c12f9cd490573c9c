#include "ui/panels/panels.h"
#include "ui/panels/side_panel.h"
#include "ui/widgets/property_rows.h"
#include "ui/widgets/theme.h"

#include <imgui.h>
#include <string>
#include <variant>
#include <vector>

namespace sandbox {

namespace {

void shape_choice(Session &session, Shape &shape, const Shape &opened) {
    std::vector<std::string> names;
    std::vector<Shape> fresh;
    for_each_shape([&]<class S>(std::type_identity<S>) {
        constexpr bool from_file = std::is_same_v<S, ObjShape>;
        if (!from_file || std::holds_alternative<ObjShape>(opened)) {
            names.emplace_back(from_file ? "model file" : format_of<S>.name);
            fresh.emplace_back(S{});
        }
    });
    std::size_t chosen = shape.index();
    if (choice_row(session, "shape", names, chosen, "The object's mesh.")) {
        shape = chosen == opened.index() ? opened : fresh[chosen];
    }
}

void shape_rows(Session &session, Shape &shape, const Shape &opened) {
    std::visit(
        [&]<class S>(S &shown) {
            const S *same_kind = std::get_if<S>(&opened);
            property_rows(session, shown, same_kind != nullptr ? *same_kind : S{});
        },
        shape);
    if (const auto *obj = std::get_if<ObjShape>(&shape)) {
        ImGui::TextWrapped("%s", obj->path.c_str());
    }
}

} // namespace

void mesh_panel(Session &session) {
    if (!object_choice(session)) {
        return;
    }
    Object &object = session.shown_object();
    const Object opened = session.opened_object();
    shape_choice(session, object.mesh, opened.mesh);
    shape_rows(session, object.mesh, opened.mesh);
    if (session.object < session.triangles.size()) {
        ImGui::TextColored(quiet_text(), "%zu triangles", session.triangles[session.object]);
    }
    checkbox(session, "wireframe", session.view.wireframe, "Draws the triangles' edges over both pictures (W).");
    heading("Transform");
    property_rows(session, object.transform, opened.transform);
}

} // namespace sandbox

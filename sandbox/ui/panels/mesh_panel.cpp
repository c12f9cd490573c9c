#include "scene/mesh_factor.h"
#include "ui/panels/panels.h"
#include "ui/panels/side_panel.h"
#include "ui/widgets/property_rows.h"
#include "ui/widgets/theme.h"

#include <fmt/format.h>
#include <imgui.h>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace sandbox {

namespace {

void shape_choice(Session &session, Shape &shape, const Shape &opened) {
    std::vector<Label> names;
    std::vector<Shape> fresh;
    for_each_shape([&]<class S>(std::type_identity<S>) {
        constexpr bool from_file = std::is_same_v<S, ObjShape>;
        if (!from_file || std::holds_alternative<ObjShape>(opened)) {
            const std::string_view word = format_of<S>.name;
            names.push_back(from_file ? session.label("mesh.model_file")
                                      : Label(word_of(session.words, word), std::string(word)));
            fresh.emplace_back(S{});
        }
    });
    std::size_t chosen = shape.index();
    if (choice_row(session, session.label("mesh.shape"), names, chosen, session.text("mesh.shape.help"))) {
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

constexpr double offered_factors[] = {0.25, 0.5, 1, 2, 4};

/// A row of factors, of which `chosen` stays pressed; the one that is clicked.
std::optional<double> factor_row(Session &session, const Label &label, std::optional<double> chosen,
                                 const std::string &hint) {
    std::optional<double> clicked;
    row_label(label.shown);
    const ScopedName name(session, label.name);
    for (const double factor : offered_factors) {
        if (toggle_button(session, mesh_factor_text(factor), chosen == factor, hint)) {
            clicked = factor;
        }
        ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    }
    ImGui::NewLine();
    return clicked;
}

/// The objects with the counts that they were opened with, times `factor`.
std::vector<Object> tessellated(const Session &session, double factor) {
    std::vector<Object> objects = session.document.scene.objects;
    const std::vector<Object> &opened = session.document.opened->scene.objects;
    for (std::size_t i = 0; i < objects.size(); ++i) {
        set_tessellation(objects[i].mesh, i < opened.size() ? opened[i].mesh : Shape(objects[i].mesh), factor);
    }
    return objects;
}

void all_meshes(Session &session) {
    heading(session.text("mesh.factors"));
    std::optional<double> all;
    for (const double factor : offered_factors) {
        all = !all && tessellated(session, factor) == session.document.scene.objects ? factor : all;
    }
    if (const auto clicked = factor_row(session, session.label("mesh.both"), all, session.text("mesh.both.help"))) {
        session.document.scene.objects = tessellated(session, *clicked);
    }
    for (const bool right : {false, true}) {
        double &factor = session.document.mesh_factors[right ? 1 : 0];
        factor =
            factor_row(session, session.label("mesh.alone", right ? "B" : "A"), factor, session.text("mesh.alone.help"))
                .value_or(factor);
    }
}

std::string triangles_text(const Session &session) {
    const auto &[a, b] = session.triangles;
    if (session.object >= a.size() || session.object >= b.size()) {
        return "";
    }
    const std::size_t left = a[session.object], right = b[session.object];
    return left == right ? session.text("mesh.triangles", left) : session.text("mesh.triangles_of_both", left, right);
}

} // namespace

void mesh_panel(Session &session) {
    if (!object_choice(session)) {
        return;
    }
    all_meshes(session);
    Object &object = session.shown_object();
    const Object opened = session.opened_object();
    shape_choice(session, object.mesh, opened.mesh);
    shape_rows(session, object.mesh, opened.mesh);
    const std::string triangles = triangles_text(session);
    ImGui::TextColored(quiet_text(), "%s", triangles.c_str());
    describe_item(session, "triangles", "", triangles);
    for (const OverlayKind &kind : overlay_kinds) {
        if (kind.on == &Overlays::lights) {
            continue; // the Lights panel has it
        }
        const Label name{title_of(session.words, kind), std::string(kind.title)};
        same_line_if_fits(kind.on == &Overlays::wireframe
                              ? ImGui::GetWindowWidth()
                              : ImGui::CalcTextSize(name.shown.c_str()).x + ImGui::GetFrameHeight() * 1.4F);
        checkbox(session, name, session.view.drawn_over.*kind.on,
                 session.text("mesh.overlay.help", help_of(session.words, kind), kind.key));
    }
    heading(session.text("mesh.transform"));
    property_rows(session, object.transform, opened.transform);
}

} // namespace sandbox

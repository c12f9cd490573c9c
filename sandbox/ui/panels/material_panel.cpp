#include "ui/panels/object_choice.h"
#include "ui/panels/panels.h"
#include "ui/session/usable_controls.h"
#include "ui/widgets/widgets.h"

#include <algorithm>
#include <filesystem>
#include <imgui.h>
#include <string>
#include <vector>

namespace sandbox {

namespace {

/// Plain, chequer, or one of the textures: the built-in ones and the scene's own.
void surface_choice(Session &session, Material &material, const Material &opened) {
    std::vector<std::string> textures = session.textures;
    for (const std::string &own : {opened.texture, material.texture}) {
        if (!own.empty() && std::ranges::find(textures, own) == textures.end()) {
            textures.push_back(own);
        }
    }
    std::vector<std::string> names{"plain", "chequer"};
    for (const std::string &texture : textures) {
        names.push_back(std::filesystem::path(texture).filename().string());
    }
    const auto found = std::ranges::find(textures, material.texture);
    std::size_t chosen = material.checker          ? 1
                         : found == textures.end() ? 0
                                                   : 2 + static_cast<std::size_t>(found - textures.begin());
    if (!choice_row(session, "surface", names, chosen, "What colours the surface besides the material")) {
        return;
    }
    material.texture = chosen >= 2 ? textures[chosen - 2] : "";
    material.checker.reset();
    if (chosen == 1) {
        material.checker = opened.checker.value_or(Checker{});
    }
}

void checker_rows(Session &session, Checker &checker, const Checker &opened) {
    slider_row(session, "cells", checker.cells, opened.cells, ranges::cells, "Cells along each axis of the object");
    color_row(session, "first colour", checker.colors[0], opened.colors[0], "Even cells");
    color_row(session, "second colour", checker.colors[1], opened.colors[1], "Odd cells");
}

} // namespace

void material_panel(Session &session) {
    if (!object_choice(session)) {
        return;
    }
    Document &document = session.document;
    Material &material = session.shown_object().material;
    const Material opened = session.opened_object().material;
    surface_choice(session, material, opened);
    const MaterialControls can = material_controls(document.scene, session.object, document.left, document.right);
    if (can.checker) {
        checker_rows(session, *material.checker, opened.checker.value_or(Checker{}));
    }
    color_row(session, "ambient", material.ambient, opened.ambient, "Share of ambient light that is sent back");
    if (can.diffuse) {
        color_row(session, "diffuse", material.diffuse, opened.diffuse, "Share of diffuse light that is sent back");
    }
    if (can.specular) {
        color_row(session, "specular", material.specular, opened.specular, "Colour of the highlights");
    }
    color_row(session, "emission", material.emission, opened.emission, "Light of its own, whatever the lamps do");
    if (can.shininess) {
        slider_row(session, "shininess n", material.shininess, opened.shininess, ranges::shininess,
                   "The exponent of the highlight: larger is smaller and sharper (up to 1e7)");
    }
    if (scene_controls(document.scene, document.left, document.right).blinn_exponent_scale) {
        slider_row(session, "Blinn n / n", document.scene.blinn_exponent_scale,
                   document.opened->scene.blinn_exponent_scale, ranges::blinn_exponent_scale,
                   "Blinn-Phong raises to this times n, for the whole scene; 4 makes its highlights match Phong's");
    }
    if (can.modulates_specular) {
        switch_row(session, "surface colours the highlight", material.texture_modulates_specular,
                   opened.texture_modulates_specular, "Multiplies the specular term, too, by the texture or chequer");
    }
    switch_row(session, "two-sided", session.shown_object().two_sided, session.opened_object().two_sided,
               "Turns the normal to the viewer where it points away");
}

} // namespace sandbox

#include "ui/panels/panels.h"
#include "ui/panels/side_panel.h"
#include "ui/widgets/property_rows.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace sandbox {

namespace {

/// Plain, checkered, or one of the textures: the built-in ones and the scene's own.
void surface_choice(Session &session, Material &material, const Material &opened) {
    std::vector<std::string> textures = session.textures;
    for (const std::string &own : {opened.texture, material.texture}) {
        if (!own.empty() && std::ranges::find(textures, own) == textures.end()) {
            textures.push_back(own);
        }
    }
    std::vector<Label> names{session.label("material.plain"), session.label("material.checker")};
    for (const std::string &texture : textures) {
        names.emplace_back(std::filesystem::path(texture).filename().string());
    }
    const auto found = std::ranges::find(textures, material.texture);
    std::size_t chosen = material.checker          ? 1
                         : found == textures.end() ? 0
                                                   : 2 + static_cast<std::size_t>(found - textures.begin());
    if (choice_row(session, session.label("material.surface"), names, chosen, session.text("material.surface.help"))) {
        material.texture = chosen >= 2 ? textures[chosen - 2] : "";
        material.checker = chosen == 1 ? std::optional(opened.checker.value_or(Checker{})) : std::nullopt;
    }
}

} // namespace

void material_panel(Session &session) {
    if (!object_choice(session)) {
        return;
    }
    Object &object = session.shown_object();
    const Object opened = session.opened_object();
    surface_choice(session, object.material, opened.material);
    if (object.material.checker) {
        property_rows(session, *object.material.checker, opened.material.checker.value_or(Checker{}));
    }
    property_rows(session, object.material, opened.material);
    property_rows(session, object, opened);
}

} // namespace sandbox

#include "ui/panels/side_panel.h"

#include "ui/panels/panels.h"
#include "ui/panels/technique_panel.h"
#include "ui/widgets/widgets.h"

#include <algorithm>
#include <fmt/format.h>
#include <imgui.h>
#include <string>
#include <vector>

namespace sandbox {

namespace {

std::string faults_title(const Session &session) {
    const auto faults_of = [](const Technique &technique) {
        return std::ranges::count_if(
            technique_keys(), [&](const TechniqueKey &key) { return key.is_fault() && key.get(technique) != 0; });
    };
    const auto a = faults_of(session.document.left);
    const auto b = faults_of(session.document.right);
    return a + b == 0 ? "Faults" : fmt::format("Faults (A {}, B {})", a, b);
}

std::string lights_title(const Session &session) {
    return fmt::format("Lights ({})", session.document.scene.lights.size());
}

struct Panel {
    std::string (*title)(const Session &);
    void (*draw)(Session &);
    bool open; ///< at first
};

constexpr Panel panels[] = {
    {[](const Session &) -> std::string { return "Technique"; }, technique_panel, true},
    {faults_title, faults_panel, false},
    {lights_title, lights_panel, true},
    {[](const Session &) -> std::string { return "Material"; }, material_panel, false},
    {[](const Session &) -> std::string { return "Mesh"; }, mesh_panel, false},
    {[](const Session &) -> std::string { return "Camera and display"; }, camera_panel, false},
};

} // namespace

void side_panel(Session &session) {
    for (const Panel &panel : panels) {
        const std::string shown = panel.title(session);
        const std::string name = shown.substr(0, shown.find(" (")); // "Lights" of "Lights (3)"
        const std::string title = shown + "###" + name;             // what stands before ### may change
        const bool open = ImGui::CollapsingHeader(title.c_str(), panel.open ? ImGuiTreeNodeFlags_DefaultOpen : 0);
        describe_item(session, name, "", shown);
        if (open) {
            const ScopedName panel_name(session, name);
            panel.draw(session);
            ImGui::Spacing();
        }
    }
}

bool object_choice(Session &session) {
    const std::vector<Object> &objects = session.document.scene.objects;
    if (objects.empty()) {
        ImGui::TextUnformatted("This scene has no object.");
        return false;
    }
    if (objects.size() > 1) {
        std::vector<Label> names;
        for (const Object &object : objects) {
            const std::size_t number = names.size() + 1;
            names.push_back(object.name.empty() ? session.label("object.numbered", number)
                                                : Label(fmt::format("{}  {}", number, object.name)));
        }
        choice_row(session, session.label("object"), names, session.object, session.text("object.help"));
    }
    return true;
}

} // namespace sandbox

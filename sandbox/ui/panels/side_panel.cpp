#include "ui/panels/panels.h"

#include <imgui.h>
#include <string>

namespace sandbox {

namespace {

int faults_on(const Technique &technique) {
    int count = 0;
    for (const TechniqueKey &key : technique_keys()) {
        count += key.is_fault() && key.get(technique) != 0 ? 1 : 0;
    }
    return count;
}

std::string faults_title(const Session &session) {
    const int a = faults_on(session.document.left);
    const int b = faults_on(session.document.right);
    return a + b == 0 ? "Faults" : "Faults (A " + std::to_string(a) + ", B " + std::to_string(b) + ")";
}

std::string lights_title(const Session &session) {
    return "Lights (" + std::to_string(session.document.scene.lights.size()) + ")";
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
        const int id = static_cast<int>(&panel - panels);
        ImGui::PushID(id);
        const std::string title = panel.title(session) + "###panel"; // what stands before ### may change
        const ImGuiTreeNodeFlags flags = panel.open ? ImGuiTreeNodeFlags_DefaultOpen : ImGuiTreeNodeFlags_None;
        if (ImGui::CollapsingHeader(title.c_str(), flags)) {
            panel.draw(session);
            ImGui::Spacing();
        }
        ImGui::PopID();
    }
}

} // namespace sandbox

#include "ui/panels/side_panel.h"

#include "ui/panels/panels.h"
#include "ui/panels/technique_panel.h"
#include "ui/widgets/widgets.h"
#include "words/row_words.h"

#include <algorithm>
#include <fmt/format.h>
#include <imgui.h>
#include <string>
#include <vector>

namespace sandbox {

namespace {

/// What stands in brackets behind a title; empty: nothing.
std::string faults_count(const Session &session) {
    const auto faults_of = [](const Technique &technique) {
        return std::ranges::count_if(
            technique_keys(), [&](const TechniqueKey &key) { return key.is_fault() && key.get(technique) != 0; });
    };
    const auto a = faults_of(session.document.left);
    const auto b = faults_of(session.document.right);
    return a + b == 0 ? "" : fmt::format("A {}, B {}", a, b);
}

std::string lights_count(const Session &session) { return fmt::format("{}", session.document.scene.lights.size()); }

struct Panel {
    std::string_view title; ///< a text's key
    void (*draw)(Session &);
    bool open; ///< at first
    std::string (*count)(const Session &) = nullptr;
};

constexpr Panel panels[] = {
    {"panel.technique", technique_panel, true},
    {"panel.faults", faults_panel, false, faults_count},
    {"panel.lights", lights_panel, true, lights_count},
    {"panel.material", material_panel, false},
    {"panel.mesh", mesh_panel, false},
    {"panel.camera", camera_panel, false},
};

} // namespace

void side_panel(Session &session) {
    for (const Panel &panel : panels) {
        Label title = session.label(panel.title);
        if (const std::string count = panel.count != nullptr ? panel.count(session) : ""; !count.empty()) {
            title.shown = session.text("panel.count", title.shown, count);
        }
        const bool open = ImGui::CollapsingHeader(title.id().c_str(), panel.open ? ImGuiTreeNodeFlags_DefaultOpen : 0);
        describe_item(session, title.name, "", title.shown);
        if (open) {
            const ScopedName panel_name(session, title.name);
            panel.draw(session);
            ImGui::Spacing();
        }
    }
}

bool object_choice(Session &session) {
    const std::vector<Object> &objects = session.document.scene.objects;
    if (objects.empty()) {
        ImGui::TextUnformatted(session.text("object.none").c_str());
        return false;
    }
    if (objects.size() > 1) {
        std::vector<Label> names;
        for (const Object &object : objects) {
            const std::size_t number = names.size() + 1;
            names.push_back(object.name.empty()
                                ? session.label("object.numbered", number)
                                : Label(fmt::format("{}  {}", number, file_text(session.words, object.name)),
                                        fmt::format("{}  {}", number, object.name)));
        }
        choice_row(session, session.label("object"), names, session.object, session.text("object.help"));
    }
    return true;
}

} // namespace sandbox

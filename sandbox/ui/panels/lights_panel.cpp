#include "ui/panels/panels.h"
#include "ui/session/edits.h"
#include "ui/widgets/property_rows.h"
#include "ui/widgets/theme.h"
#include "words/row_words.h"

#include <algorithm>
#include <fmt/format.h>
#include <imgui.h>
#include <optional>
#include <string>

namespace sandbox {

namespace {

Label kind_label(const Session &session, const LightKind &kind) {
    return {title_of(session.words, kind), std::string(kind.word)};
}

/// One switch for all lights of a kind.
void kind_switches(Session &session) {
    Scene &scene = session.document.scene;
    for (const LightKind &kind : light_kinds) {
        const Label name = kind_label(session, kind);
        if (&kind != light_kinds.begin()) {
            same_line_if_fits(ImGui::CalcTextSize(name.shown.c_str()).x + ImGui::GetFrameHeight() * 1.4F);
        }
        bool on = std::ranges::any_of(scene.lights, [&](const Light &l) { return l.type == kind.type && l.enabled; });
        if (checkbox(session, name, on, session.text("lights.kind.help", name.shown))) {
            switch_lights(scene, kind.type, on);
        }
    }
}

void kind_choice(Session &session, Light &light) {
    for (const LightKind &kind : light_kinds) {
        const Label name = kind_label(session, kind);
        if (&kind != light_kinds.begin()) {
            same_line_if_fits(ImGui::CalcTextSize(name.shown.c_str()).x + ImGui::GetFrameHeight() * 1.4F);
        }
        if (radio_button(session, name, light.type == kind.type, "")) {
            set_type(light, kind.type, session.document.scene.camera);
        }
    }
}

void cone_switch(Session &session, Light &light, const Light &opened) {
    bool cone = has_cone(light);
    if (control_row(session, row_of(session, "lights.cone", any), cone, opened.cutoff_degrees != 180)) {
        set_cutoff(light, !cone ? 180 : opened.cutoff_degrees != 180 ? opened.cutoff_degrees : Light{}.cutoff_degrees);
    }
}

void light_rows(Session &session, Light &light, const Light &opened) {
    kind_choice(session, light);
    if (kind_of(light.type).conical) {
        cone_switch(session, light, opened);
    }
    const Light before = light;
    property_rows(session, light, opened);
    keep_valid(light, before);
}

ImVec4 shown_color(const glm::dvec3 &color) {
    const auto part = [](double value) { return static_cast<float>(std::clamp(value, 0.0, 1.0)); };
    return {part(color.x), part(color.y), part(color.z), 1};
}

/// A light's line and, unfolded, its rows; true if the user removes it.
bool light_entry(Session &session, std::size_t index) {
    Light &light = session.document.scene.lights[index];
    ImGui::Checkbox("##on", &light.enabled);
    describe_item(session, "on", session.text("lights.on.help"), light.enabled ? "on" : "off");
    ImGui::SameLine();
    ImGui::ColorButton("##colour", shown_color(light.color),
                       ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_NoDragDrop,
                       ImVec2(ImGui::GetFontSize(), ImGui::GetFrameHeight()));
    ImGui::SameLine();
    const std::string name = fmt::format("{}  {}", index + 1, title_of(session.words, kind_of(light.type)));
    const std::string title = name + "###light"; // what stands before ### may change
    const float button = ImGui::GetFrameHeight();
    const float right_edge = ImGui::GetWindowContentRegionMax().x;
    bool open = false;
    if (light.enabled) {
        ImGui::SetNextItemOpen(index == 0, ImGuiCond_FirstUseEver);
        open = ImGui::TreeNodeEx(title.c_str(), ImGuiTreeNodeFlags_AllowItemOverlap | ImGuiTreeNodeFlags_FramePadding |
                                                    ImGuiTreeNodeFlags_NoTreePushOnOpen);
        describe_item(session, "title", "", name);
    } else {
        ImGui::AlignTextToFramePadding();
        ImGui::TextColored(quiet_text(), "%s", session.text("lights.off", name).c_str());
    }
    ImGui::SameLine(right_edge - button);
    const bool remove = ImGui::Button("\xC3\x97", ImVec2(button, 0));
    describe_item(session, "remove", session.text("lights.remove.help"));
    if (open && !remove) {
        light_rows(session, light, session.opened_light(index));
        ImGui::Separator();
    }
    return remove;
}

void add_buttons(Session &session) {
    Scene &scene = session.document.scene;
    bool first = true;
    for (const LightKind &kind : light_kinds) {
        if (!can_add_light(scene, kind.type)) {
            continue;
        }
        const Label kind_name = kind_label(session, kind);
        const Label label{"+ " + kind_name.shown, "+ " + kind_name.name};
        if (!std::exchange(first, false)) {
            same_line_if_fits(button_width(label.shown));
        }
        if (button(session, label, session.text("lights.add.help"))) {
            add_light(scene, kind.type);
        }
    }
}

} // namespace

void lights_panel(Session &session) {
    Scene &scene = session.document.scene;
    kind_switches(session);
    for (const OverlayKind &kind : overlay_kinds) {
        if (kind.on == &Overlays::lights) {
            checkbox(session, {title_of(session.words, kind), std::string(kind.title)},
                     session.view.drawn_over.*kind.on,
                     session.text("lights.overlay.help", help_of(session.words, kind), kind.key));
        }
    }
    std::optional<std::size_t> removed;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const ScopedName name(session, std::to_string(i + 1));
        if (light_entry(session, i)) {
            removed = i;
        }
    }
    if (removed) {
        scene.lights.erase(scene.lights.begin() + static_cast<std::ptrdiff_t>(*removed));
    }
    add_buttons(session);
    heading(session.text("lights.whole_scene"));
    property_rows(session, scene, session.document.opened->scene);
}

} // namespace sandbox

#include "ui/panels/panels.h"
#include "ui/session/edits.h"
#include "ui/session/usable_controls.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <algorithm>
#include <imgui.h>
#include <optional>
#include <string>

namespace sandbox {

namespace {

constexpr LightType types[] = {LightType::directional, LightType::point, LightType::spot};

const char *name_of(LightType type) {
    return type == LightType::directional ? "directional" : type == LightType::point ? "point" : "spot";
}

/// One switch for all lights of a type.
void type_switches(Session &session) {
    Scene &scene = session.document.scene;
    for (const LightType type : types) {
        const bool is_first = type == types[0];
        const float width = ImGui::CalcTextSize(name_of(type)).x + ImGui::GetFrameHeight() * 1.4F;
        if (!is_first) {
            same_line_if_fits(width);
        }
        bool on = std::ranges::any_of(scene.lights, [type](const Light &l) { return l.type == type && l.enabled; });
        if (ImGui::Checkbox(name_of(type), &on)) {
            switch_lights(scene, type, on);
        }
        hint_for_item(session,
                      std::string("All ") + name_of(type) + " lights on or off; adds one where there is none.");
    }
}

void type_choice(Session &session, Light &light) {
    for (const LightType type : types) {
        if (type != types[0]) {
            ImGui::SameLine();
        }
        if (ImGui::RadioButton(name_of(type), light.type == type)) {
            set_type(light, type, session.document.scene.camera);
        }
    }
}

void attenuation_rows(Session &session, Light &light, const Light &opened) {
    Attenuation &value = light.attenuation;
    const Attenuation &before = opened.attenuation;
    heading("Attenuation over the distance d");
    bool changed = slider_row(session, "constant", value.constant, before.constant, ranges::attenuation,
                              "constant in 1 / (constant + linear d + quadratic d\xC2\xB2)");
    changed |= slider_row(session, "linear, 1/unit", value.linear, before.linear, ranges::attenuation,
                          "linear in 1 / (constant + linear d + quadratic d\xC2\xB2)");
    changed |= slider_row(session, "quadratic, 1/unit\xC2\xB2", value.quadratic, before.quadratic, ranges::attenuation,
                          "quadratic in 1 / (constant + linear d + quadratic d\xC2\xB2)");
    if (changed) {
        keep_attenuation_valid(value);
    }
}

void cone_rows(Session &session, Light &light, const Light &opened, bool shape) {
    bool cone = light.cutoff_degrees != 180;
    if (switch_row(session, "cone", cone, opened.cutoff_degrees != 180,
                   "Off: the spot shines in all directions (cutoff 180 degrees) and its exponent is dropped")) {
        set_cutoff(light, !cone ? 180 : opened.cutoff_degrees != 180 ? opened.cutoff_degrees : Light{}.cutoff_degrees);
    }
    if (!shape || !cone) {
        return;
    }
    double cutoff = light.cutoff_degrees;
    if (slider_row(session, "cutoff, degrees", cutoff, std::min(opened.cutoff_degrees, 90.0), ranges::cutoff_degrees,
                   "Half angle of the cone")) {
        set_cutoff(light, cutoff);
    }
    ControlRange inside = ranges::cutoff_degrees;
    inside.high = inside.slider_high = light.cutoff_degrees;
    slider_row(session, "inner, degrees", light.inner_cutoff_degrees,
               std::min(opened.inner_cutoff_degrees, light.cutoff_degrees), inside,
               "Where the soft edge begins; equal to the cutoff: a hard edge");
    slider_row(session, "spot exponent", light.exponent, opened.exponent, ranges::spot_exponent,
               "How the light gathers along the axis: cos(angle) to this power");
}

void light_rows(Session &session, Light &light, const Light &opened) {
    const LightControls can = light_controls(light, session.document.left, session.document.right);
    type_choice(session, light);
    color_row(session, "colour", light.color, opened.color, "Multiplies all three intensities");
    slider_row(session, "ambient", light.ambient, opened.ambient, ranges::intensity, "Ambient intensity");
    slider_row(session, "diffuse", light.diffuse, opened.diffuse, ranges::intensity, "Diffuse intensity");
    if (can.specular) {
        slider_row(session, "specular", light.specular, opened.specular, ranges::intensity, "Specular intensity");
    }
    if (can.position) {
        vector_row(session, "position, units", light.position, opened.position, ranges::coordinate,
                   "World space x, y, z; drag sideways");
    }
    if (can.direction) {
        const glm::dvec3 before = light.direction;
        vector_row(session, "direction", light.direction, opened.direction, ranges::direction,
                   "The way the light travels, x, y, z; its length does not matter; drag sideways");
        light.direction = light.direction == glm::dvec3(0) ? before : light.direction;
    }
    if (can.cone) {
        cone_rows(session, light, opened, can.cone_shape);
    }
    if (can.attenuation) {
        attenuation_rows(session, light, opened);
    }
    if (can.attenuate_ambient) {
        switch_row(session, "attenuate ambient", light.attenuate_ambient, opened.attenuate_ambient,
                   "Ambient light, too, fades with distance and outside the cone");
    }
}

ImVec4 shown_color(const glm::dvec3 &color) {
    const auto part = [](double value) { return static_cast<float>(std::clamp(value, 0.0, 1.0)); };
    return {part(color.x), part(color.y), part(color.z), 1};
}

/// A light's line and, unfolded, its rows; true if it is to be removed.
bool light_entry(Session &session, std::size_t index) {
    Light &light = session.document.scene.lights[index];
    ImGui::Checkbox("##on", &light.enabled);
    hint_for_item(session, "On or off: a light that is off costs nothing.");
    ImGui::SameLine();
    ImGui::ColorButton("##colour", shown_color(light.color),
                       ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_NoDragDrop,
                       ImVec2(ImGui::GetFontSize(), ImGui::GetFrameHeight()));
    ImGui::SameLine();
    const std::string title = std::to_string(index + 1) + "  " + name_of(light.type) + "###light";
    const float button = ImGui::GetFrameHeight();
    const float right_edge = ImGui::GetWindowContentRegionMax().x;
    bool open = false;
    if (light.enabled) {
        ImGui::SetNextItemOpen(index == 0, ImGuiCond_FirstUseEver);
        open = ImGui::TreeNodeEx(title.c_str(), ImGuiTreeNodeFlags_AllowItemOverlap | ImGuiTreeNodeFlags_FramePadding |
                                                    ImGuiTreeNodeFlags_NoTreePushOnOpen);
    } else {
        ImGui::AlignTextToFramePadding();
        ImGui::TextColored(quiet_text(), "%zu  %s, off", index + 1, name_of(light.type));
    }
    ImGui::SameLine(right_edge - button);
    const bool remove = ImGui::Button("\xC3\x97", ImVec2(button, 0));
    hint_for_item(session, "Remove this light.");
    if (open && !remove) {
        light_rows(session, light, session.opened_light(index));
        ImGui::Separator();
    }
    return remove;
}

void add_buttons(Session &session) {
    Scene &scene = session.document.scene;
    bool first = true;
    for (const LightType type : types) {
        if (!can_add_light(scene, type)) {
            continue;
        }
        const std::string label = std::string("+ ") + name_of(type);
        if (!first) {
            same_line_if_fits(ImGui::CalcTextSize(label.c_str()).x + ImGui::GetStyle().FramePadding.x * 2);
        }
        first = false;
        if (ImGui::Button(label.c_str())) {
            add_light(scene, type);
        }
        hint_for_item(session, "Adds a light over the camera's right shoulder, up to 8 of each type.");
    }
}

} // namespace

void lights_panel(Session &session) {
    Scene &scene = session.document.scene;
    type_switches(session);
    std::optional<std::size_t> removed;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        if (light_entry(session, i)) {
            removed = i;
        }
        ImGui::PopID();
    }
    if (removed) {
        scene.lights.erase(scene.lights.begin() + static_cast<std::ptrdiff_t>(*removed));
    }
    add_buttons(session);
    color_row(session, "scene ambient", scene.ambient, session.document.opened->scene.ambient,
              "Light that comes from everywhere, whatever the lamps do");
}

} // namespace sandbox

#include "ui/widgets/widgets.h"

#include "ui/widgets/theme.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>

namespace sandbox {

namespace {

constexpr float label_ems = 9.2F; // of a row, in text heights

std::string formatted(double value, const char *format) {
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

/// A slider over what is usual, wider where the opened scene is; typed numbers may be anything that a scene file takes.
ControlRange sliding(ControlRange range, double opened) {
    range.slider_low = std::min(range.slider_low, opened);
    range.slider_high = opened > range.slider_high ? std::min(range.high, opened * 2) : range.slider_high;
    return range;
}

/// After the control was drawn: right click, what may not be, and the hint.
bool settled(Session &session, bool changed, double &value, double before, double opened, const ControlRange &range,
             const char *what) {
    if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) {
        value = opened;
        changed = true;
    }
    if (changed) {
        value = std::isfinite(value) ? std::clamp(value, range.low, range.high) : before;
    }
    hint_for_item(session, std::string(what) + ".  Ctrl+click: type a number.  Right-click: back to " +
                               formatted(opened, range.format) + ".");
    return changed && value != before;
}

bool slider(Session &session, double &value, double opened, const ControlRange &range, const char *what) {
    const ControlRange shown = sliding(range, opened);
    const double before = value;
    const ImGuiSliderFlags flags = shown.logarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None;
    const bool changed = ImGui::SliderScalar("##value", ImGuiDataType_Double, &value, &shown.slider_low,
                                             &shown.slider_high, shown.format, flags);
    return settled(session, changed, value, before, opened, range, what);
}

bool number(Session &session, double &value, double opened, const ControlRange &range, const char *what) {
    const double before = value;
    const float speed = static_cast<float>((range.slider_high - range.slider_low) / 400);
    const bool changed =
        ImGui::DragScalar("##value", ImGuiDataType_Double, &value, speed, nullptr, nullptr, range.format);
    return settled(session, changed, value, before, opened, range, what);
}

/// Colour pickers work in float; six decimals bring 0.8 back as 0.8.
double from_float(float value) {
    return std::isfinite(value) ? std::clamp(std::round(static_cast<double>(value) * 1e6) / 1e6, 0.0, 1e6) : 0;
}

} // namespace

void hint_for_item(Session &session, const std::string &what) {
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) || ImGui::IsItemActive()) {
        session.hint = what;
    }
}

void row_label(const char *label) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(label);
    ImGui::SameLine(ImGui::GetFontSize() * label_ems);
    ImGui::SetNextItemWidth(-1);
}

void heading(const char *text) {
    ImGui::Spacing();
    ImGui::TextColored(quiet_text(), "%s", text);
}

void wrapped_text(const ImVec4 &color, const std::string &text) {
    ImGui::PushTextWrapPos(0);
    ImGui::TextColored(color, "%s", text.c_str());
    ImGui::PopTextWrapPos();
}

ImTextureID texture_id(unsigned texture) {
    // NOLINTNEXTLINE(performance-no-int-to-ptr): the OpenGL backend takes a texture's name as a pointer
    return reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(texture));
}

void same_line_if_fits(float width) {
    ImGui::SameLine();
    if (ImGui::GetContentRegionAvail().x < width) {
        ImGui::NewLine();
    }
}

bool toggle_button(const char *label, bool on) {
    if (on) {
        ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
        ImGui::PushStyleColor(ImGuiCol_ButtonHovered, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
        ImGui::PushStyleColor(ImGuiCol_Text, text_on_accent());
    }
    const bool clicked = ImGui::Button(label);
    if (on) {
        ImGui::PopStyleColor(3);
    }
    return clicked;
}

bool slider_row(Session &session, const char *label, double &value, double opened, const ControlRange &range,
                const char *what) {
    row_label(label);
    ImGui::PushID(label);
    const bool changed = slider(session, value, opened, range, what);
    ImGui::PopID();
    return changed;
}

bool slider_row(Session &session, const char *label, int &value, int opened, const ControlRange &range,
                const char *what) {
    double number = value;
    const bool changed = slider_row(session, label, number, opened, range, what);
    if (changed) {
        value = static_cast<int>(std::lround(number));
    }
    return changed;
}

bool color_row(Session &session, const char *label, glm::dvec3 &value, const glm::dvec3 &opened, const char *what) {
    row_label(label);
    ImGui::PushID(label);
    float rgb[3] = {static_cast<float>(value.x), static_cast<float>(value.y), static_cast<float>(value.z)};
    bool changed =
        ImGui::ColorEdit3("##value", rgb,
                          ImGuiColorEditFlags_Float | ImGuiColorEditFlags_HDR | ImGuiColorEditFlags_NoOptions |
                              ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_NoDragDrop);
    if (changed) {
        value = {from_float(rgb[0]), from_float(rgb[1]), from_float(rgb[2])};
    }
    if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) {
        value = opened;
        changed = true;
    }
    hint_for_item(session,
                  std::string(what) + ".  The square opens a picker.  Right-click: back to the scene's colour.");
    ImGui::PopID();
    return changed;
}

bool vector_row(Session &session, const char *label, glm::dvec3 &value, const glm::dvec3 &opened,
                const ControlRange &range, const char *what) {
    row_label(label);
    ImGui::PushID(label);
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float width = (ImGui::GetContentRegionAvail().x - 2 * gap) / 3;
    bool changed = false;
    for (int i = 0; i < 3; ++i) {
        ImGui::PushID(i);
        if (i > 0) {
            ImGui::SameLine(0, gap);
        }
        ImGui::SetNextItemWidth(width);
        changed |= number(session, value[i], opened[i], range, what);
        ImGui::PopID();
    }
    ImGui::PopID();
    return changed;
}

bool switch_row(Session &session, const char *label, bool &value, bool opened, const char *what) {
    bool changed = ImGui::Checkbox(label, &value);
    if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) {
        changed = value != opened;
        value = opened;
    }
    hint_for_item(session, std::string(what) + ".");
    return changed;
}

bool choice_row(Session &session, const char *label, std::span<const std::string> names, std::size_t &chosen,
                const char *what) {
    row_label(label);
    ImGui::PushID(label);
    const std::size_t before = chosen;
    const char *preview = chosen < names.size() ? names[chosen].c_str() : "";
    if (ImGui::BeginCombo("##value", preview)) {
        for (std::size_t i = 0; i < names.size(); ++i) {
            ImGui::PushID(static_cast<int>(i));
            if (ImGui::Selectable(names[i].c_str(), i == chosen)) {
                chosen = i;
            }
            ImGui::PopID();
        }
        ImGui::EndCombo();
    }
    hint_for_item(session, std::string(what) + ".");
    ImGui::PopID();
    return chosen != before;
}

} // namespace sandbox

#include "ui/widgets/widgets.h"

#include "ui/widgets/fonts.h"
#include "ui/widgets/line_breaks.h"
#include "ui/widgets/theme.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <fmt/printf.h>
#include <utility>

namespace sandbox {

namespace {

constexpr float label_ems = 9.2F; // of a row, in text heights

/// "cutoff" of "cutoff, degrees".
std::string row_name(const Label &label) { return label.name.substr(0, label.name.find(", ")); }

/// Behind a number's control. A scene file's range holds, for typed numbers too.
bool finish_number(Session &session, const Row &row, double &value, double before, double opened) {
    if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) {
        value = opened;
    }
    if (value != before) {
        value = std::isfinite(value) ? nearest_accepted(value, row.range) : before;
    }
    describe_item(session, row_name(row.label),
                  row.hint + "  " + session.text("row.number.help", fmt::sprintf(row.range.slider.format, opened)),
                  fmt::sprintf(row.range.slider.format, value), value);
    return value != before;
}

bool number(Session &session, const Row &row, double &value, double opened) {
    const double before = value;
    const auto speed = static_cast<float>((row.range.slider.high - row.range.slider.low) / 400);
    ImGui::DragScalar("##value", ImGuiDataType_Double, &value, speed, nullptr, nullptr, row.range.slider.format);
    return finish_number(session, row, value, before, opened);
}

template <int N>
bool vector_row(Session &session, const Row &row, glm::vec<N, double> &value, const glm::vec<N, double> &opened) {
    row_label(row.label.shown);
    const ScopedName name(session, row_name(row.label));
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float width = (ImGui::GetContentRegionAvail().x - (N - 1) * gap) / N;
    bool changed = false;
    for (int i = 0; i < N; ++i) {
        const Row each{std::string(1, "xyz"[i]), row.range, row.hint + "  " + session.text("row.vector.help")};
        const ScopedId component(each.label.name);
        if (i > 0) {
            ImGui::SameLine(0, gap);
        }
        ImGui::SetNextItemWidth(width);
        changed |= number(session, each, value[i], opened[i]);
    }
    return changed;
}

/// Colour pickers work in float; six decimals bring 0.8 back as 0.8.
double from_float(float value, const Range &range) {
    return std::isfinite(value) ? nearest_accepted(std::round(static_cast<double>(value) * 1e6) / 1e6, range) : 0;
}

bool color_row(Session &session, const Row &row, glm::dvec3 &value, const glm::dvec3 &opened) {
    row_label(row.label.shown);
    const ScopedId id(row.label.name);
    float rgb[3] = {static_cast<float>(value.x), static_cast<float>(value.y), static_cast<float>(value.z)};
    bool changed =
        ImGui::ColorEdit3("##value", rgb,
                          ImGuiColorEditFlags_Float | ImGuiColorEditFlags_HDR | ImGuiColorEditFlags_NoOptions |
                              ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_NoDragDrop);
    if (changed) {
        value = {from_float(rgb[0], row.range), from_float(rgb[1], row.range), from_float(rgb[2], row.range)};
    }
    if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) {
        changed = value != opened;
        value = opened;
    }
    describe_item(session, row_name(row.label), row.hint + "  " + session.text("row.colour.help"));
    return changed;
}

Label numbered(const Label &label, std::size_t number) {
    return {fmt::format("{} {}", label.shown, number), fmt::format("{} {}", label.name, number)};
}

/// What the current window's clipping leaves of it.
Widget on_screen(ImVec2 low, ImVec2 high, std::string text, std::optional<double> value) {
    const ImDrawList &list = *ImGui::GetWindowDrawList();
    const ImVec2 clip_low = list.GetClipRectMin(), clip_high = list.GetClipRectMax();
    return {std::max(low.x, clip_low.x),
            std::max(low.y, clip_low.y),
            std::min(high.x, clip_high.x),
            std::min(high.y, clip_high.y),
            std::move(text),
            value};
}

} // namespace

Row row_of(const Session &session, std::string_view key, const Range &range) {
    return {session.label(key), range, session.text(std::string(key) + ".help")};
}

bool slider(Session &session, const Row &row, double &value, double opened) {
    Slider shown = row.range.slider;
    shown.low = std::min(shown.low, opened);
    shown.high = opened > shown.high ? std::min(row.range.high, opened * 2) : shown.high;
    const double before = value;
    const ScopedId id(row.label.name);
    ImGui::SliderScalar("##value", ImGuiDataType_Double, &value, &shown.low, &shown.high, shown.format,
                        shown.logarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None);
    return finish_number(session, row, value, before, opened);
}

bool control_row(Session &session, const Row &row, double &value, double opened) {
    row_label(row.label.shown);
    return slider(session, row, value, opened);
}

bool control_row(Session &session, const Row &row, int &value, int opened) {
    double number = value;
    const bool changed = control_row(session, row, number, opened);
    value = static_cast<int>(std::lround(number));
    return changed;
}

bool control_row(Session &session, const Row &row, bool &value, bool opened) {
    bool changed = ImGui::Checkbox(row.label.id().c_str(), &value);
    if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) {
        changed = value != opened;
        value = opened;
    }
    describe_item(session, row_name(row.label), row.hint, value ? "on" : "off");
    return changed;
}

bool control_row(Session &session, const Row &row, glm::dvec2 &value, const glm::dvec2 &opened) {
    return vector_row<2>(session, row, value, opened);
}

bool control_row(Session &session, const Row &row, glm::dvec3 &value, const glm::dvec3 &opened) {
    return row.range.a_color ? color_row(session, row, value, opened) : vector_row<3>(session, row, value, opened);
}

bool control_row(Session &session, const Row &row, std::array<glm::dvec3, 2> &value,
                 const std::array<glm::dvec3, 2> &opened) {
    bool changed = false;
    for (std::size_t i = 0; i < value.size(); ++i) {
        changed |= control_row(session, {numbered(row.label, i + 1), row.range, row.hint}, value[i], opened[i]);
    }
    return changed;
}

bool choice_row(Session &session, const Label &label, std::span<const Label> choices, std::size_t &chosen,
                const std::string &hint) {
    row_label(label.shown);
    return combo(session, label.name, choices, chosen, hint);
}

bool combo(Session &session, const std::string &name, std::span<const Label> choices, std::size_t &chosen,
           const std::string &hint) {
    const std::size_t before = chosen;
    const std::string shown = chosen < choices.size() ? choices[chosen].shown : "";
    if (ImGui::BeginCombo(("##" + name).c_str(), shown.c_str())) {
        for (std::size_t i = 0; i < choices.size(); ++i) {
            const ScopedName list(session, name);
            const ScopedId entry(i);
            if (ImGui::Selectable(choices[i].id().c_str(), i == chosen)) {
                chosen = i;
            }
            describe_item(session, choices[i].name, hint);
        }
        ImGui::EndCombo();
    }
    describe_item(session, name, hint, shown);
    return chosen != before;
}

bool button(Session &session, const Label &label, const std::string &hint) {
    const bool clicked = ImGui::Button(label.id().c_str());
    describe_item(session, label.name, hint, label.shown);
    return clicked;
}

bool small_button(Session &session, const Label &label, const std::string &hint) {
    const bool clicked = ImGui::SmallButton(label.id().c_str());
    describe_item(session, label.name, hint, label.shown);
    return clicked;
}

bool checkbox(Session &session, const Label &label, bool &on, const std::string &hint) {
    const bool changed = ImGui::Checkbox(label.id().c_str(), &on);
    describe_item(session, label.name, hint, on ? "on" : "off");
    return changed;
}

bool radio_button(Session &session, const Label &label, bool on, const std::string &hint) {
    const bool clicked = ImGui::RadioButton(label.id().c_str(), on);
    describe_item(session, label.name, hint, on ? "on" : "off");
    return clicked;
}

bool toggle_button(Session &session, const Label &label, bool on, const std::string &hint) {
    if (on) {
        ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
        ImGui::PushStyleColor(ImGuiCol_ButtonHovered, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
        ImGui::PushStyleColor(ImGuiCol_Text, text_on_accent());
    }
    const bool clicked = ImGui::Button(label.id().c_str());
    describe_item(session, label.name, hint, label.shown);
    ImGui::PopStyleColor(on ? 3 : 0);
    return clicked;
}

std::optional<float> panel_edge(Session &session, std::string_view name, ImVec2 size, float &chosen,
                                const std::string &hint) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ScopedId id{std::string(name)};
    ImGui::InvisibleButton("edge", size);
    const bool upright = size.y > size.x, hovered = ImGui::IsItemHovered();
    const bool dragged = ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 1);
    const bool has_keys = ImGui::IsItemFocused() && ImGui::GetIO().NavVisible;
    const auto pressed = [&](ImGuiKey key) { return has_keys && is_key_pressed(key); };
    if (ImGui::IsItemClicked(ImGuiMouseButton_Right) || pressed(ImGuiKey_Enter) ||
        (hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))) {
        chosen = 0;
    }
    if (hovered || ImGui::IsItemActive()) {
        ImGui::SetMouseCursor(upright ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
    }
    if (hovered || has_keys || ImGui::IsItemActive()) {
        ImGui::GetWindowDrawList()->AddRectFilled(
            low, {low.x + size.x, low.y + size.y},
            ImGui::GetColorU32(has_keys ? ImGuiCol_NavHighlight : ImGuiCol_SliderGrab));
    }
    describe_item(session, name, hint + "  " + session.text("edge.help"));
    if (dragged) {
        return upright ? ImGui::GetMousePos().x : ImGui::GetMousePos().y;
    }
    const int steps = static_cast<int>(pressed(upright ? ImGuiKey_RightArrow : ImGuiKey_DownArrow)) -
                      static_cast<int>(pressed(upright ? ImGuiKey_LeftArrow : ImGuiKey_UpArrow));
    const float now = upright ? low.x + size.x : low.y;
    return steps != 0 ? std::optional(now + static_cast<float>(steps) * ImGui::GetFontSize()) : std::nullopt;
}

float edge_thickness() { return std::max(4.0F, std::floor(ImGui::GetFontSize() * 0.3F)); }

void describe_item(Session &session, std::string_view name, const std::string &hint, std::string text,
                   std::optional<double> value) {
    if (!hint.empty() && (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) || ImGui::IsItemActive())) {
        session.hint = hint;
    }
    if (!session.widgets.listening()) {
        return;
    }
    if (session.widgets.wanted(name)) {
        ImGui::SetScrollHereY();
    }
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    session.widgets.add(name, on_screen(low, high, text.empty() ? std::string(name) : std::move(text), value));
}

void describe_text(Session &session, std::string_view name, ImVec2 low, ImVec2 high, std::string text) {
    if (session.widgets.listening()) {
        session.widgets.add(name, on_screen(low, high, std::move(text), {}));
    }
}

void row_label(const std::string &label) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(label.c_str());
    if (const float column = ImGui::GetFontSize() * label_ems;
        ImGui::GetCursorStartPos().x + ImGui::CalcTextSize(label.c_str()).x < column) { // else the control stands below
        ImGui::SameLine(column);
    }
    ImGui::SetNextItemWidth(-1);
}

void heading(std::string_view text) {
    ImGui::Spacing();
    wrapped_text(quiet_text(), std::string(text));
}

void wrapped_text(const ImVec4 &color, const std::string &text) {
    if (has_chinese(text)) { // Dear ImGui breaks lines at spaces alone
        const ImFont &font = *ImGui::GetFont();
        const float scale = ImGui::GetFontSize() / font.FontSize;
        const auto advance = [&](char32_t code) { return font.GetCharAdvance(static_cast<ImWchar>(code)) * scale; };
        ImGui::TextColored(color, "%s", in_lines(text, ImGui::GetContentRegionAvail().x, advance).c_str());
        return;
    }
    ImGui::PushTextWrapPos(0);
    ImGui::TextColored(color, "%s", text.c_str());
    ImGui::PopTextWrapPos();
}

void large_text(Session &session, const char *name, const std::string &text) {
    ImGui::PushFont(lecture_font());
    wrapped_text(ImGui::GetStyleColorVec4(ImGuiCol_Text), text);
    ImGui::PopFont();
    describe_item(session, name, "", text);
}

ImTextureID texture_id(unsigned texture) {
    // NOLINTNEXTLINE(performance-no-int-to-ptr): the OpenGL backend takes a texture's name as a pointer
    return reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(texture));
}

unsigned texture_name(ImTextureID id) { return static_cast<unsigned>(reinterpret_cast<std::intptr_t>(id)); }

bool is_key_pressed(ImGuiKey key) {
#if IMGUI_VERSION_NUM >= 18900
    return ImGui::IsKeyPressed(key);
#else
    return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key));
#endif
}

void scroll_by_keys() {
    if (!ImGui::IsWindowFocused(ImGuiFocusedFlags_ChildWindows)) {
        return;
    }
    const float line = ImGui::GetTextLineHeightWithSpacing() * 2, page = ImGui::GetWindowHeight() * 0.8F;
    for (const auto &[key, step] :
         {std::pair(ImGuiKey_UpArrow, -line), std::pair(ImGuiKey_DownArrow, line), std::pair(ImGuiKey_PageUp, -page),
          std::pair(ImGuiKey_PageDown, page), std::pair(ImGuiKey_Home, -1e6F), std::pair(ImGuiKey_End, 1e6F)}) {
        if (is_key_pressed(key)) {
            ImGui::SetScrollY(std::clamp(ImGui::GetScrollY() + step, 0.0F, ImGui::GetScrollMaxY()));
        }
    }
}

void same_line_if_fits(float width) {
    ImGui::SameLine();
    if (ImGui::GetContentRegionAvail().x < width) {
        ImGui::NewLine();
    }
}

float button_width(const std::string &label) {
    return ImGui::CalcTextSize(label.c_str()).x + ImGui::GetStyle().FramePadding.x * 2;
}

} // namespace sandbox

#include "ui/panels/technique_table.h"

#include "ui/session/edits.h"
#include "ui/session/usable_controls.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <imgui.h>
#include <string>

namespace sandbox {

namespace {

std::string row_text(const TechniqueKey &key, int value, bool square) {
    const std::string name(key.values[static_cast<std::size_t>(value)].name);
    return square ? std::string(key.name) + ": " + name : name;
}

/// The mark of one side; true when clicked.
bool mark(const TechniqueKey &key, int value, bool square, const Technique &technique) {
    const bool set = key.get(technique) == value;
    if (!square) {
        return ImGui::RadioButton("##mark", set) && !set;
    }
    bool on = set;
    return ImGui::Checkbox("##mark", &on);
}

void side_cell(Session &session, const TechniqueKey &key, int value, bool square, bool right) {
    Technique &technique = session.technique(right);
    if (!value_open(key, value, session.document.scene, technique)) {
        return;
    }
    ImGui::PushID(right ? 1 : 0);
    ImGui::PushStyleColor(ImGuiCol_CheckMark, side_color(right));
    if (mark(key, value, square, technique)) {
        set_key(technique, key, key.get(technique) == value ? 0 : value);
    }
    ImGui::PopStyleColor();
    hint_for_item(session, std::string(right ? "B" : "A") + ", " + std::string(key.name) + ": " +
                               std::string(key.values[static_cast<std::size_t>(value)].look_for) + ".");
    ImGui::PopID();
}

bool set_somewhere(const Session &session, const TechniqueKey &key, int value) {
    return key.get(session.document.left) == value || key.get(session.document.right) == value;
}

} // namespace

bool begin_technique_table(const char *id) {
    if (!ImGui::BeginTable(id, 3, ImGuiTableFlags_NoSavedSettings | ImGuiTableFlags_SizingFixedFit)) {
        return false;
    }
    const float mark_width = ImGui::GetFrameHeight();
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("A", ImGuiTableColumnFlags_WidthFixed, mark_width);
    ImGui::TableSetupColumn("B", ImGuiTableColumnFlags_WidthFixed, mark_width);
    ImGui::TableNextRow();
    for (const bool right : {false, true}) {
        ImGui::TableSetColumnIndex(right ? 2 : 1);
        const float indent = (mark_width - ImGui::CalcTextSize("A").x) / 2;
        ImGui::SetCursorPosX(ImGui::GetCursorPosX() + indent);
        ImGui::TextColored(side_color(right), right ? "B" : "A");
    }
    return true;
}

void end_technique_table() { ImGui::EndTable(); }

void technique_row(Session &session, const TechniqueKey &key, int value, bool square) {
    const Scene &scene = session.document.scene;
    if (!value_open(key, value, scene, session.document.left) &&
        !value_open(key, value, scene, session.document.right)) {
        return;
    }
    ImGui::PushID(&key);
    ImGui::PushID(value);
    ImGui::TableNextRow();
    ImGui::TableSetColumnIndex(0);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(row_text(key, value, square).c_str());
    const std::string look_for(key.values[static_cast<std::size_t>(value)].look_for);
    hint_for_item(session, std::string(key.name) + ": " + look_for + ".");
    if (square && set_somewhere(session, key, value)) {
        wrapped_text(quiet_text(), look_for); // the fault is on
    }
    for (const bool right : {false, true}) {
        ImGui::TableSetColumnIndex(right ? 2 : 1);
        side_cell(session, key, value, square, right);
    }
    ImGui::PopID();
    ImGui::PopID();
}

} // namespace sandbox

#include "ui/panels/technique_panel.h"

#include "shading/own_text.h"
#include "ui/session/edits.h"
#include "ui/session/fault_names.h"
#include "ui/session/own_files.h"
#include "ui/session/usable_controls.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"
#include "words/row_words.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <imgui.h>
#include <string>

namespace sandbox {

namespace {

/// "per-pixel", "normals=model-matrix": the words of commands and files.
std::string value_name(const TechniqueKey &key, int value) {
    const std::string_view name = key.values[static_cast<std::size_t>(value)].name;
    return key.kind == TechniqueKey::Kind::choice ? std::string(name) : fmt::format("{}={}", key.name, name);
}

/// "normals=model-matrix: wrong under non-uniform scale."
std::string value_hint(const Session &session, const TechniqueKey &key, int value) {
    return session.text("technique.value.help", value_name(key, value), look_for(session.words, key, value));
}

/// The mark of one side; true when clicked.
bool mark(const TechniqueKey &key, bool set) {
    if (key.kind == TechniqueKey::Kind::choice) {
        return ImGui::RadioButton("##mark", set) && !set;
    }
    bool on = set;
    return ImGui::Checkbox("##mark", &on);
}

/// A side's technique, with the text that its row "own shading" stands for.
Technique ready_for_own(const Session &session, bool right) {
    Technique technique = session.technique(right);
    technique.own = own_of(session, right);
    return technique;
}

void side_cell(Session &session, const TechniqueKey &key, int value, bool right) {
    Technique &technique = session.technique(right);
    if (!value_open(key, value, session.document.scene, ready_for_own(session, right))) {
        return;
    }
    const bool set = key.get(technique) == value;
    const ScopedName side(session, right ? "B" : "A");
    ImGui::PushStyleColor(ImGuiCol_CheckMark, side_color(right));
    if (mark(key, set)) {
        technique = ready_for_own(session, right);
        set_key(technique, key, set ? 0 : value);
    }
    ImGui::PopStyleColor();
    describe_item(session, value_name(key, value),
                  session.text("technique.side.help", right ? "B" : "A", value_hint(session, key, value)),
                  set ? "on" : "off");
}

/// Quiet text beside the label, or under it where the column is too narrow.
void remark(const std::string &text) {
    ImGui::SameLine();
    if (ImGui::GetContentRegionAvail().x < ImGui::CalcTextSize(text.c_str()).x) {
        ImGui::NewLine();
    }
    ImGui::TextColored(quiet_text(), "%s", text.c_str());
}

/// Where a value is on but does nothing, though the other side could show it.
std::optional<char> idle_side(const Document &document, const TechniqueKey &key, int value) {
    const auto idle = [&](const Technique &side) {
        return key.get(side) == value && value_use(key, value, document.scene, side) == ValueUse::no_effect;
    };
    return idle(document.left) ? std::optional('A') : idle(document.right) ? std::optional('B') : std::nullopt;
}

void label_cell(Session &session, const TechniqueKey &key, int value, bool effect) {
    const Document &document = session.document;
    ImGui::AlignTextToFramePadding();
    const std::string fault = fault_name(session.words, key, value);
    const std::string name = fault.empty() ? title_of(session.words, key, value) : fault;
    wrapped_text(effect ? ImGui::GetStyleColorVec4(ImGuiCol_Text) : quiet_text(), name);
    describe_item(session, value_name(key, value), value_hint(session, key, value), name);
    const bool set = key.get(document.left) == value || key.get(document.right) == value;
    if (!effect) {
        remark(session.text("technique.no_effect"));
    } else if (const auto idle = idle_side(document, key, value)) {
        remark(session.text("technique.no_effect_in", *idle));
    }
    if (set && key.kind != TechniqueKey::Kind::choice) {
        const std::string text = look_for(session.words, key, value);
        wrapped_text(quiet_text(), text);
        describe_item(session, value_name(key, value) + "/look for", "", text);
    }
}

/// Rows are values of technique keys, columns are A and B: one click sets one side.
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

/// Round marks choose among frequencies and models; square ones switch a setting on and off (off is the key's default).
/// No row where both sides refuse the value; "no effect here" where no side's picture of this scene can show it; no
/// mark on a side that cannot use it.
void value_row(Session &session, const TechniqueKey &key, int value) {
    const Document &document = session.document;
    const ValueUse best = std::max(value_use(key, value, document.scene, ready_for_own(session, false)),
                                   value_use(key, value, document.scene, ready_for_own(session, true)));
    if (best == ValueUse::refused) {
        return;
    }
    const ScopedId id(title_of(key, value)); // in English: what a state belongs to
    ImGui::TableNextRow();
    ImGui::TableSetColumnIndex(0);
    label_cell(session, key, value, best == ValueUse::open);
    for (const bool right : {false, true}) {
        ImGui::TableSetColumnIndex(right ? 2 : 1);
        side_cell(session, key, value, right);
    }
}

/// A row for each value but the default of all settings of this kind.
void setting_rows(Session &session, TechniqueKey::Kind kind) {
    for (const TechniqueKey &key : technique_settings) {
        for (int value = 1; key.kind == kind && value < static_cast<int>(key.values.size()); ++value) {
            value_row(session, key, value);
        }
    }
}

void heading_row(const std::string &text) {
    ImGui::TableNextRow();
    ImGui::TableSetColumnIndex(0);
    heading(text);
}

void key_rows(Session &session, const TechniqueKey &key, const std::string &title) {
    heading_row(title);
    for (int value = 0; value < static_cast<int>(key.values.size()); ++value) {
        value_row(session, key, value);
    }
}

/// What `auto` may differ by, of the sides that have it.
void tolerance_rows(Session &session) {
    constexpr Range range{.low = 1e-6, .high = 1, .slider = {1.0 / 2550, 1.0 / 10, "%.3g", true}};
    for (const bool right : {false, true}) {
        if (Technique &side = session.technique(right); side.frequency == Frequency::automatic) {
            const ScopedName name(session, right ? "B" : "A");
            const ScopedId id(right ? 1U : 0U);
            control_row(session, row_of(session, "technique.tolerance_row", range), side.tolerance, default_tolerance);
        }
    }
}

/// Says that A is drawn on the processor, where it is; unticking the box ends that.
void textbook_row(Session &session) {
    bool textbook = session.document.left_is_textbook();
    if (textbook && ImGui::Checkbox(session.label("technique.textbook").id().c_str(), &textbook)) {
        session.document.textbook.reset();
    }
}

/// The file of a side that shows own shading, and the way to open one.
void own_row(Session &session) {
    for (const bool right : {false, true}) {
        if (const Technique &side = session.technique(right); side.model == Model::own) {
            const std::string name = std::filesystem::path(side.own->file).filename().string();
            const std::string text = session.text("technique.own_file", right ? "B" : "A", name);
            wrapped_text(side_color(right), text);
            describe_item(session, right ? "B/file" : "A/file", side.own->file, text);
        }
    }
    if (button(session, session.label("technique.open_own"), session.text("technique.open_own.help"))) {
        session.requests.ask_open = true;
    }
}

} // namespace

void technique_panel(Session &session) {
    textbook_row(session);
    if (session.same_picture) {
        wrapped_text(quiet_text(), session.text("technique.same_picture"));
    }
    if (!begin_technique_table("technique")) {
        return;
    }
    key_rows(session, frequency_key, session.text("technique.frequency.title"));
    key_rows(session, model_key, session.text("technique.model.title"));
    heading_row(session.text("technique.variants"));
    setting_rows(session, TechniqueKey::Kind::variant);
    ImGui::EndTable();
    tolerance_rows(session);
    own_row(session);
}

void faults_panel(Session &session) {
    if (begin_technique_table("faults")) {
        setting_rows(session, TechniqueKey::Kind::fault);
        ImGui::EndTable();
    }
}

} // namespace sandbox

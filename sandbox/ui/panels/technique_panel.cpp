#include "ui/panels/panels.h"
#include "ui/panels/technique_table.h"
#include "ui/widgets/widgets.h"

#include <imgui.h>

namespace sandbox {

namespace {

void heading_row(const char *text) {
    ImGui::TableNextRow();
    ImGui::TableSetColumnIndex(0);
    heading(text);
}

void key_rows(Session &session, const TechniqueKey &key, const char *title) {
    heading_row(title);
    for (int value = 0; value < static_cast<int>(key.values.size()); ++value) {
        technique_row(session, key, value);
    }
}

/// Says that A is drawn on the processor, where it is; unticking the box ends that.
void textbook_row(Session &session) {
    bool textbook = session.document.left_is_textbook();
    if (textbook && ImGui::Checkbox("A: a textbook's float32, on the processor", &textbook)) {
        session.document.textbook.reset();
    }
}

} // namespace

void technique_panel(Session &session) {
    textbook_row(session);
    if (!begin_technique_table("technique")) {
        return;
    }
    key_rows(session, frequency_key, "Frequency: where the equation runs");
    key_rows(session, model_key, "Reflection model");
    heading_row("Variants");
    setting_rows(session, TechniqueKey::Kind::variant);
    end_technique_table();
}

void faults_panel(Session &session) {
    if (begin_technique_table("faults")) {
        setting_rows(session, TechniqueKey::Kind::fault);
        end_technique_table();
    }
}

} // namespace sandbox

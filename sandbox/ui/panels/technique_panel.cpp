#include "ui/panels/panels.h"
#include "ui/panels/technique_table.h"
#include "ui/widgets/widgets.h"

#include <imgui.h>
#include <string>

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
        technique_row(session, key, value, false);
    }
}

/// Where A is drawn on the processor: says so, and the way out of it.
void textbook_row(Session &session) {
    bool textbook = session.document.left_is_textbook();
    if (textbook && ImGui::Checkbox("A: a textbook's float32, on the processor", &textbook)) {
        session.document.textbook.reset();
    }
}

} // namespace

void technique_panel(Session &session) {
    textbook_row(session);
    const auto keys = technique_keys();
    if (!begin_technique_table("technique")) {
        return;
    }
    key_rows(session, keys[0], "Frequency: where the equation runs");
    key_rows(session, keys[1], "Reflection model");
    heading_row("Variants");
    for (const TechniqueKey &key : keys.subspan(2)) {
        for (int value = 1; !key.fault && value < static_cast<int>(key.values.size()); ++value) {
            technique_row(session, key, value, true);
        }
    }
    end_technique_table();
}

} // namespace sandbox

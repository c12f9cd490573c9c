#include "ui/error_time_view.h"
#include "ui/widgets.h"

namespace sandbox {

namespace {

void model_buttons(Session &session, const WorkPrecision &measured, ErrorTimeView &view) {
    bool first = true;
    for (const Model model : models_of(measured)) {
        const std::string name(name_of(model));
        if (!first) {
            ImGui::SameLine(0, 2);
        }
        first = false;
        if (toggle_button(name.c_str(), view.model == model)) {
            view.model = model;
        }
        hint_for_item(session, "Techniques of this reflection model; each model is judged against its own truth.");
    }
}

void norm_buttons(Session &session, ErrorTimeView &view) {
    for (const ErrorNorm norm : error_norms) {
        const std::string name(name_of(norm));
        if (norm != error_norms[0]) {
            ImGui::SameLine(0, 2);
        }
        if (toggle_button(name.c_str(), view.norm == norm)) {
            view.norm = norm;
        }
        hint_for_item(session,
                      "What of the differences from the truth is shown, over all channels of the compared pixels.");
    }
}

} // namespace

void error_time_choices(Session &session, const WorkPrecision &measured, ErrorTimeView &view) {
    model_buttons(session, measured, view);
    same_line_if_fits(ImGui::GetFontSize() * 16);
    norm_buttons(session, view);
}

} // namespace sandbox

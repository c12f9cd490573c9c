#include "ui/tabs/error_time_view.h"
#include "ui/widgets/widgets.h"

#include <span>
#include <string>
#include <vector>

namespace sandbox {

namespace {

/// Where buttons would take too many lines.
template <typename Choice>
void combo(Session &session, const char *id, std::span<const Choice> choices, Choice &chosen, const char *hint) {
    ImGui::SetNextItemWidth(ImGui::CalcTextSize("99th percentile").x + ImGui::GetFrameHeight() * 1.5F);
    if (ImGui::BeginCombo(id, std::string(name_of(chosen)).c_str())) {
        for (const Choice choice : choices) {
            if (ImGui::Selectable(std::string(name_of(choice)).c_str(), choice == chosen)) {
                chosen = choice;
            }
        }
        ImGui::EndCombo();
    }
    hint_for_item(session, hint);
}

/// Beside each other.
template <typename Choice>
void buttons(Session &session, std::span<const Choice> choices, Choice &chosen, const char *hint) {
    for (const Choice &choice : choices) {
        if (&choice != choices.data()) {
            ImGui::SameLine(0, 2);
        }
        if (toggle_button(std::string(name_of(choice)).c_str(), choice == chosen)) {
            chosen = choice;
        }
        hint_for_item(session, hint);
    }
}

constexpr const char *model_hint = "Techniques of this reflection model; each model is judged against its own truth.";
constexpr const char *norm_hint = "Of the differences from the truth, over all channels of the compared pixels.";

} // namespace

void error_time_choices(Session &session, const WorkPrecision &measured, ErrorTimeView &view, bool narrow) {
    const std::vector<Model> models = models_of(measured);
    if (narrow) {
        combo<Model>(session, "##model", models, view.model, model_hint);
        ImGui::SameLine();
        combo<ErrorNorm>(session, "##norm", error_norms, view.norm, norm_hint);
    } else {
        buttons<Model>(session, models, view.model, model_hint);
        ImGui::SameLine();
        buttons<ErrorNorm>(session, error_norms, view.norm, norm_hint);
    }
}

} // namespace sandbox

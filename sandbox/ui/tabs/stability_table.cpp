#include "ui/tabs/stability_table.h"

#include "ui/views/view_captions.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"
#include "words/row_words.h"

#include <algorithm>
#include <string>

namespace sandbox {

namespace {

/// True when it is clicked.
bool row(Session &session, const ListedCase &listed, bool chosen, bool wide) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const std::string name = shortened(short_name(listed.definition), ImGui::GetContentRegionAvail().x);
    const bool clicked =
        ImGui::Selectable(Label(name, listed.name()).id().c_str(), chosen, ImGuiSelectableFlags_SpanAllColumns);
    const std::string symptom = file_text(session.words, listed.definition.symptom);
    describe_item(session, listed.name(), symptom);
    if (wide) {
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(symptom.c_str());
    }
    ImGui::TableNextColumn();
    ImGui::TextColored(verdict_color(textbook_verdict(listed)), "%s", textbook_text(session.words, listed).c_str());
    ImGui::TableNextColumn();
    ImGui::TextColored(verdict_color(robust_verdict(listed)), "%s", robust_text(session.words, listed).c_str());
    if (wide) {
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(cost_text(listed).c_str());
    }
    return clicked;
}

void group_row(const std::string &group) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextColored(quiet_text(), "%s", group.c_str());
}

/// A list's title, over all columns.
void title_row(const std::string &title) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const ImDrawList &list = *ImGui::GetWindowDrawList();
    const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    ImGui::PushClipRect(list.GetClipRectMin(), {right, list.GetClipRectMax().y}, false);
    ImGui::TextDisabled("%s", title.c_str());
    ImGui::PopClipRect();
}

} // namespace

ImVec4 verdict_color(Verdict verdict) {
    return verdict == Verdict::breaks ? error_text() : verdict == Verdict::holds ? side_color(true) : quiet_text();
}

std::optional<std::size_t> case_table(Session &session, const std::vector<ListedCase> &cases, const CaseFilter &filter,
                                      std::optional<std::size_t> chosen, ImVec2 size) {
    const float em = ImGui::GetFontSize();
    const bool wide = size.x > em * 52;
    constexpr ImGuiTableFlags flags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerV |
                                      ImGuiTableFlags_SizingFixedFit;
    if (!ImGui::BeginTable("cases", wide ? 5 : 3, flags, size)) {
        return std::nullopt;
    }
    ImGui::TableSetupScrollFreeze(0, 1);
    if (wide) {
        ImGui::TableSetupColumn(session.text("stability.column.case").c_str(), ImGuiTableColumnFlags_WidthFixed,
                                em * 13);
        ImGui::TableSetupColumn(session.text("stability.column.symptom").c_str(), ImGuiTableColumnFlags_WidthStretch);
    } else {
        ImGui::TableSetupColumn(session.text("stability.column.case").c_str(), ImGuiTableColumnFlags_WidthStretch);
    }
    ImGui::TableSetupColumn(session.text("stability.column.textbook").c_str(), ImGuiTableColumnFlags_WidthFixed,
                            std::min(em * 9.8F, size.x * 0.38F));
    ImGui::TableSetupColumn(session.text("stability.column.robust").c_str(), ImGuiTableColumnFlags_WidthFixed,
                            std::min(em * 7, size.x * 0.27F));
    if (wide) {
        ImGui::TableSetupColumn(session.text("stability.column.cost").c_str(), ImGuiTableColumnFlags_WidthFixed,
                                em * 3);
    }
    ImGui::TableHeadersRow();
    std::optional<std::size_t> clicked;
    for (const CaseList &list : lists_of(session.words, cases, filter)) {
        if (!list.title.empty()) {
            title_row(list.title);
        }
        std::string group;
        for (const std::size_t i : list.cases) {
            if (cases[i].definition.group != group) {
                group = cases[i].definition.group;
                group_row(file_text(session.words, group));
            }
            if (row(session, cases[i], i == chosen, wide)) {
                clicked = i;
            }
        }
    }
    ImGui::EndTable();
    return clicked;
}

} // namespace sandbox

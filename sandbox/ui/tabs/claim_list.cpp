#include "ui/tabs/claim_list.h"

#include "ui/widgets/fonts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/verdict_mark.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>
#include <imgui.h>
#include <string>

namespace sandbox {

namespace {

VerdictMark mark_of(const ClaimResult &claim) {
    return !claim.checked ? VerdictMark::dot : claim.passed ? VerdictMark::tick : VerdictMark::cross;
}

/// With what was measured.
std::string verdict(const Session &session, VerdictMark mark, const std::string &measured) {
    return mark == VerdictMark::none    ? session.text("lesson_tab.measuring")
           : mark == VerdictMark::tick  ? session.text("lesson_tab.holds", measured)
           : mark == VerdictMark::cross ? session.text("lesson_tab.fails", measured)
                                        : session.text("lesson_tab.shown", measured);
}

/// The value in large letters, then its bound and the claim's words. Of words in a GLSL text there is no value.
void claim_row(Session &session, std::size_t number, const ClaimResult &claim, VerdictMark mark) {
    const ImVec4 text = ImGui::GetStyleColorVec4(ImGuiCol_Text);
    const bool value = mark != VerdictMark::tick || !claim.bound.empty();
    ImGui::BeginGroup();
    ImGui::PushFont(value ? lecture_font() : ImGui::GetFont());
    const float indent = ImGui::GetTextLineHeight();
    draw_mark(mark);
    wrapped_text(mark == VerdictMark::none    ? quiet_text()
                 : mark == VerdictMark::cross ? error_text()
                                              : text,
                 mark == VerdictMark::none ? session.text("lesson_tab.measuring")
                 : value                   ? claim.measured
                                           : claim.what);
    ImGui::PopFont();
    const std::string bound = claim.bound.empty() ? "" : session.text("lesson_tab.claimed", claim.bound);
    const std::string unit = claim.bound.empty() ? "" : std::string(claim.unit);
    ImGui::Indent(indent);
    if (!bound.empty()) {
        wrapped_text(quiet_text(), bound + (unit.empty() ? "" : " ") + unit);
    }
    if (value) {
        wrapped_text(text, claim.what);
    }
    ImGui::Unindent(indent);
    ImGui::EndGroup();
    const std::string shown = verdict(session, mark, claim.measured);
    describe_item(session, fmt::format("claim {}", number), "",
                  fmt::format("{}{}{}: {}", shown, bound.empty() ? "" : ", ", bound, claim.what));
    ImGui::Spacing();
}

} // namespace

void claim_list(Session &session, std::span<const LessonClaim> claims, std::span<const ClaimResult> measured) {
    if (claims.empty()) {
        return;
    }
    heading(session.text("lesson_tab.claims"));
    for (std::size_t i = 0; i < claims.size(); ++i) {
        const bool ready = i < measured.size();
        claim_row(session, i + 1, ready ? measured[i] : claim_words(session.words, claims[i]),
                  ready ? mark_of(measured[i]) : VerdictMark::none);
    }
}

} // namespace sandbox

#include "ui/tabs/claim_list.h"

#include "ui/widgets/fonts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>
#include <imgui.h>
#include <string>

namespace sandbox {

namespace {

enum class Mark { none, dot, tick, cross };

Mark mark_of(const ClaimResult &claim) { return !claim.checked ? Mark::dot : claim.passed ? Mark::tick : Mark::cross; }

/// With what was measured.
std::string verdict(const Session &session, Mark mark, const std::string &measured) {
    return mark == Mark::none    ? session.text("lesson_tab.measuring")
           : mark == Mark::tick  ? session.text("lesson_tab.holds", measured)
           : mark == Mark::cross ? session.text("lesson_tab.fails", measured)
                                 : session.text("lesson_tab.shown", measured);
}

/// Drawn, for not every font has such letters; as wide as a line is high.
void draw_mark(Mark mark) {
    const float size = ImGui::GetTextLineHeight();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const auto at = [&](float x, float y) { return ImVec2{low.x + x * size, low.y + y * size}; };
    ImDrawList &list = *ImGui::GetWindowDrawList();
    const float thickness = size * 0.13F;
    if (mark == Mark::tick) {
        const ImVec2 points[] = {at(0.08F, 0.55F), at(0.34F, 0.82F), at(0.82F, 0.2F)};
        list.AddPolyline(points, 3, ImGui::GetColorU32(side_color(true)), ImDrawFlags_None, thickness);
    } else if (mark == Mark::cross) {
        const ImU32 color = ImGui::GetColorU32(error_text());
        list.AddLine(at(0.15F, 0.2F), at(0.75F, 0.8F), color, thickness);
        list.AddLine(at(0.75F, 0.2F), at(0.15F, 0.8F), color, thickness);
    } else if (mark == Mark::dot) {
        list.AddCircleFilled(at(0.45F, 0.5F), size * 0.12F, ImGui::GetColorU32(quiet_text()));
    }
    ImGui::Dummy({size, size});
    ImGui::SameLine(0, size * 0.2F);
}

/// The value in large letters, then its bound and the claim's words. Of words in a GLSL text there is no value.
void claim_row(Session &session, std::size_t number, const ClaimResult &claim, Mark mark) {
    const ImVec4 text = ImGui::GetStyleColorVec4(ImGuiCol_Text);
    const bool value = mark != Mark::tick || !claim.bound.empty();
    ImGui::BeginGroup();
    ImGui::PushFont(value ? lecture_font() : ImGui::GetFont());
    const float indent = ImGui::GetTextLineHeight();
    draw_mark(mark);
    wrapped_text(mark == Mark::none    ? quiet_text()
                 : mark == Mark::cross ? error_text()
                                       : text,
                 mark == Mark::none ? session.text("lesson_tab.measuring")
                 : value            ? claim.measured
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
                  ready ? mark_of(measured[i]) : Mark::none);
    }
}

} // namespace sandbox

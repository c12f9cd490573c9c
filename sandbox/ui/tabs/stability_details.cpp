#include "ui/tabs/stability_details.h"

#include "measure/report/stability_report.h"
#include "measure/report/text.h"
#include "ui/tabs/stability_table.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"
#include "words/row_words.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>

namespace sandbox {

namespace {

constexpr float loupe_share = 1.0F / 6; // of the picture's width that the loupe shows

void story_line(const std::string &name, const std::string &text) {
    ImGui::TextColored(quiet_text(), "%s", name.c_str());
    ImGui::SameLine(ImGui::GetFontSize() * 5);
    wrapped_text(ImGui::GetStyleColorVec4(ImGuiCol_Text), text);
}

/// What A and B show.
std::string views_text(const Words &words, const StabilityCase &definition) {
    const bool half = definition.textbook_target == TextbookTarget::half;
    return words.text(definition.textbook ? "stability.a_renderer" : "stability.a_processor") +
           (half ? words.text("stability.half_here") : "") + words.text("stability.b_robust");
}

void failed_rows(const Words &words, const StabilityResult &result) {
    for (const StabilityRow &row : result.rows) {
        if (!row.refused.empty()) {
            wrapped_text(quiet_text(), words.format("stability.refused", to_string(row.technique), row.refused));
        } else if (!row.passed) {
            wrapped_text(error_text(), words.format("stability.failed_row", to_string(row.technique),
                                                    short_number(words, row.error), row.metrics.nonfinite_pixels));
        }
    }
}

/// Around the mouse, larger: one wrong pixel is easily missed.
void loupe(const DisplayTexture &picture) {
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 size = ImGui::GetItemRectSize();
    const ImVec2 mouse = ImGui::GetMousePos();
    const auto around = [](float at) { return std::clamp(at, loupe_share / 2, 1 - loupe_share / 2); };
    const float u = around((mouse.x - low.x) / size.x);
    const float v = around(1 - (mouse.y - low.y) / size.y); // the texture's first row is at the bottom
    const float side = ImGui::GetFontSize() * 12;
    constexpr float half = loupe_share / 2;
    ImGui::BeginTooltip();
    ImGui::Image(texture_id(picture.texture()), {side, side}, {u - half, v + half}, {u + half, v - half});
    ImGui::EndTooltip();
}

struct Caption {
    std::string name, figure;
    ImVec4 color;
};

Caption caption(const Words &words, std::string_view form, Verdict verdict, const StabilityRow &row) {
    return {words.format("stability.caption", words.text(form), verdict_word(words, verdict)), error_words(words, row),
            verdict_color(verdict)};
}

void picture(const DisplayTexture &shown, const Caption &caption, float side) {
    ImGui::BeginGroup();
    const ImVec4 plain(1, 1, 1, 1);
    ImGui::Image(texture_id(shown.texture()), {side, side}, {0, 1}, {1, 0}, plain,
                 ImGui::GetStyleColorVec4(ImGuiCol_Border));
    if (ImGui::IsItemHovered()) {
        loupe(shown);
    }
    ImGui::TextColored(caption.color, "%s", caption.name.c_str());
    ImGui::TextUnformatted(caption.figure.c_str());
    ImGui::EndGroup();
}

/// A whole number of screen pixels a pixel, so that none is lost and none is wider than its neighbour.
float picture_side(float room, int width) {
    const float fitting = std::floor(room / static_cast<float>(width));
    return static_cast<float>(width) * std::clamp(fitting, 1.0F, 4.0F);
}

} // namespace

void StabilityDetails::pictures(const Words &words, const ListedCase &listed) {
    const StabilityResult &result = *listed.result;
    const std::array<const ByteImage *, 3> images{&result.textbook_image, &result.robust_image,
                                                  &result.reference_image};
    for (std::size_t i = 0; i < images.size(); ++i) {
        if (!pictures_[i]) {
            pictures_[i].emplace(*images[i]);
        }
    }
    const std::array<Caption, 3> captions{
        caption(words, "stability.textbook", textbook_verdict(listed), result.textbook),
        caption(words, "stability.robust", robust_verdict(listed), result.worst()),
        Caption{words.text("stability.reference"), words.text("stability.in_double"),
                ImGui::GetStyleColorVec4(ImGuiCol_Text)}};
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float room = (ImGui::GetContentRegionAvail().x - 2 * gap) / 3 - 2; // less the border
    const float side = picture_side(room, images[0]->size.width);
    for (std::size_t i = 0; i < images.size(); ++i) {
        if (i > 0) {
            same_line_if_fits(side);
        }
        picture(*pictures_[i], captions[i], side);
    }
}

void StabilityDetails::draw(const Session &session, const ListedCase &listed) {
    const Words &words = session.words;
    const StabilityCase &definition = listed.definition;
    ImGui::TextUnformatted(definition.name.c_str());
    if (listed.result) {
        pictures(session.words, listed);
        failed_rows(session.words, *listed.result);
    } else {
        wrapped_text(quiet_text(), words.text("stability.not_run"));
    }
    if (textbook_verdict(listed) == Verdict::holds) {
        story_line(words.text("stability.here"), seen_on_words(words, definition));
    }
    story_line(words.text("stability.symptom"), file_text(words, definition.symptom));
    story_line(words.text("stability.cause"), file_text(words, definition.cause));
    story_line(words.text("stability.met_in"), file_text(words, definition.source));
    story_line(words.text("stability.bound"), bound_words(words, definition));
    if (const std::string cost = listed.result ? cost_words(words, *listed.result) : ""; !cost.empty()) {
        story_line(words.text("stability.cost_title"), cost);
    }
    story_line(words.text("stability.textbook_title"), textbook_words(words, definition));
    story_line(words.text("stability.views"), views_text(words, definition));
}

} // namespace sandbox

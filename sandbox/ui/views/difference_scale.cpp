#include "ui/views/difference_scale.h"

#include "capture/picture.h"
#include "capture/picture_ranges.h"
#include "image/difference.h"
#include "ui/views/view_captions.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <string>
#include <utility>

namespace sandbox {

namespace {

ImU32 packed(const glm::vec3 &color) { return ImGui::GetColorU32(ImVec4(color.r, color.g, color.b, 1)); }

void draw_bar(const Rect &bar) {
    ImDrawList &list = *ImGui::GetWindowDrawList();
    constexpr int parts = 32;
    const float step = bar.width() / parts;
    for (int i = 0; i < parts; ++i) {
        const float from = 2.0F * static_cast<float>(i) / parts - 1;
        const ImU32 left = packed(difference_color(from));
        const ImU32 right = packed(difference_color(from + 2.0F / parts));
        const float x = bar.low.x + step * static_cast<float>(i);
        list.AddRectFilledMultiColor({x, bar.low.y}, {x + step, bar.high.y}, left, right, right, left);
    }
    list.AddRect(bar.low, bar.high, ImGui::GetColorU32(ImGuiCol_Border));
}

void centred_text(float x, float y, const std::string &text) {
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    ImGui::GetWindowDrawList()->AddText({x - width / 2, y}, ImGui::GetColorU32(ImGuiCol_Text), text.c_str());
}

} // namespace

void difference_scale(const Session &session, const Rect &picture) {
    const float em = ImGui::GetFontSize();
    const float half = std::min(picture.width() * 0.25F, em * 14);
    const float middle = (picture.low.x + picture.high.x) / 2;
    const float top = picture.high.y - em * 2.6F;
    const Rect bar{{middle - half, top}, {middle + half, top + em}};
    ImDrawList &list = *ImGui::GetWindowDrawList();
    const auto [first, second] = names_of(session.words, session.view.difference_of);
    const std::string left = session.text("difference.brighter", second),
                      right = session.text("difference.brighter", first);
    const float gap = em * 0.7F;
    const float wider = std::max(ImGui::CalcTextSize(left.c_str()).x, ImGui::CalcTextSize(right.c_str()).x) + gap * 2;
    list.AddRectFilled({bar.low.x - wider, top - em * 0.4F}, {bar.high.x + wider, picture.high.y},
                       ImGui::GetColorU32(ImGuiCol_WindowBg, 0.9F));
    draw_bar(bar);
    for (int i = -2; i <= 2; ++i) {
        const float x = middle + half / 2 * static_cast<float>(i);
        centred_text(x, bar.high.y + 2, i == 0 ? "0" : fmt::format("{:+.3g}", i / 2.0 / session.view.gain));
    }
    const ImU32 color = ImGui::GetColorU32(ImGuiCol_Text);
    list.AddText({bar.low.x - gap - ImGui::CalcTextSize(left.c_str()).x, top - 1}, color, left.c_str());
    list.AddText({bar.high.x + gap, top - 1}, color, right.c_str());
}

void difference_controls(Session &session, const ViewPainter &painter, const Rect &picture) {
    const ScopedName scope(session, "Difference");
    const float em = ImGui::GetFontSize();
    const float middle = (picture.low.x + picture.high.x) / 2;
    ImGui::SetCursorScreenPos(
        {std::max(picture.low.x + 6, middle - em * 19), picture.high.y + ImGui::GetFrameHeight()});
    constexpr std::pair<DifferenceOf, std::string_view> choices[] = {{DifferenceOf::a_b, "difference.a_b"},
                                                                     {DifferenceOf::a_truth, "difference.a_truth"},
                                                                     {DifferenceOf::b_truth, "difference.b_truth"}};
    for (const auto &[of, name] : choices) {
        if (toggle_button(session, session.label(name), session.view.difference_of == of,
                          session.text("difference.of.help"))) {
            session.view.difference_of = of;
        }
        ImGui::SameLine(0, 2);
    }
    ImGui::SameLine();
    ImGui::TextUnformatted(session.text("difference.gain").c_str());
    ImGui::SameLine();
    ImGui::SetNextItemWidth(em * (picture.width() < em * 36 ? 2.5F : 7.0F));
    slider(session, row_of(session, "difference.gain", gain_range), session.view.gain, ViewSettings{}.gain);
    ImGui::SameLine();
    const double largest = painter.largest_difference();
    if (button(session, session.label("difference.fit"), session.text("difference.fit.help")) && largest > 0 &&
        std::isfinite(largest)) {
        session.view.gain = nearest_accepted(1 / largest, gain_range);
    }
    ImGui::SameLine();
    const bool edges = session.view.difference_of != DifferenceOf::a_b && std::isfinite(largest) && largest > 0;
    const std::string text =
        shortened(difference_text(session.words, largest) + (edges ? session.text("difference.edges") : ""),
                  picture.high.x - ImGui::GetCursorScreenPos().x);
    ImGui::TextColored(std::isfinite(largest) ? ImGui::GetStyleColorVec4(ImGuiCol_Text) : error_text(), "%s",
                       painter.difference_texture() != 0 ? text.c_str() : "");
    describe_item(session, "largest", "", text);
}

} // namespace sandbox

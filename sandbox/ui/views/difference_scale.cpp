#include "ui/views/difference_scale.h"

#include "render/difference_palette.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <string>

namespace sandbox {

namespace {

constexpr Range gain_range{.low = 0.1, .high = 1e9, .slider = {1, 1000, "%.4g", true}};

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

/// The bar, five numbers below it and, if they fit, what its ends mean beside it.
void draw_scale(const Rect &bar, const Rect &picture, double gain) {
    draw_bar(bar);
    for (int i = -2; i <= 2; ++i) {
        const float x = (bar.low.x + bar.high.x) / 2 + bar.width() / 4 * static_cast<float>(i);
        centred_text(x, bar.high.y + 2, i == 0 ? "0" : fmt::format("{:+.3g}", i / 2.0 / gain));
    }
    const float gap = ImGui::GetFontSize();
    const float width = ImGui::CalcTextSize("B brighter").x;
    if (bar.low.x - gap - width > picture.low.x) {
        ImDrawList &list = *ImGui::GetWindowDrawList();
        const float y = bar.low.y - 1;
        list.AddText({bar.low.x - gap - width, y}, ImGui::GetColorU32(side_color(true)), "B brighter");
        list.AddText({bar.high.x + gap, y}, ImGui::GetColorU32(side_color(false)), "A brighter");
    }
}

} // namespace

float difference_scale_height() { return ImGui::GetFrameHeight() * 2 + ImGui::GetTextLineHeight() + 14; }

void difference_scale(Session &session, const ViewPainter &painter, const Rect &picture) {
    const float font = ImGui::GetFontSize();
    const float middle = (picture.low.x + picture.high.x) / 2;
    const float half = std::min(picture.width() * 0.25F, font * 14);
    const float top = picture.high.y + 5;
    draw_scale({{middle - half, top}, {middle + half, top + font}}, picture, session.view.gain);

    ImGui::SetCursorScreenPos({middle - half, top + font * 2 + 8});
    ImGui::PushItemWidth(half);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("gain");
    ImGui::SameLine();
    slider(session, {"gain", gain_range, "Multiplies the difference before it is coloured."}, session.view.gain,
           ViewSettings{}.gain);
    ImGui::PopItemWidth();
    ImGui::SameLine();
    const double largest = painter.largest_difference();
    if (button(session, "fit", "The gain at which the largest difference reaches the end of the scale.") &&
        largest > 0 && std::isfinite(largest)) {
        session.view.gain = nearest_accepted(1 / largest, gain_range);
    }
    ImGui::SameLine();
    const std::string number = std::isfinite(largest) ? fmt::format("{:.3g}", largest) : "not finite";
    ImGui::TextColored(std::isfinite(largest) ? ImGui::GetStyleColorVec4(ImGuiCol_Text) : error_text(),
                       "largest |A \xE2\x88\x92 B|  %s", number.c_str());
}

} // namespace sandbox

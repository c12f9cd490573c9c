#include "ui/tabs/bottom_tabs.h"

#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>
#include <string>

namespace sandbox {

namespace {

constexpr std::array curve_names{"A", "B", "truth"};

double luminance(const glm::vec4 &c) { return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b; } // of linear Rec. 709

/// The luminance along one row of the pictures; empty: not known.
using Curve = std::vector<double>;

Curve curve_of(const Image *image, int row) {
    Curve curve;
    for (int x = 0; image != nullptr && row < image->size.height && x < image->size.width; ++x) {
        curve.push_back(luminance(image->at(x, row)));
    }
    return curve;
}

void draw_curve(const Curve &curve, ImVec2 low, ImVec2 high, double top, ImU32 color, float thickness) {
    std::vector<ImVec2> points;
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const double x = (static_cast<double>(i) + 0.5) / static_cast<double>(curve.size());
        const double y = std::isfinite(curve[i]) ? std::clamp(curve[i] / top, 0.0, 1.0) : 1;
        points.emplace_back(low.x + static_cast<float>(x) * (high.x - low.x),
                            high.y - static_cast<float>(y) * (high.y - low.y));
    }
    if (points.size() > 1) {
        ImGui::GetWindowDrawList()->AddPolyline(points.data(), static_cast<int>(points.size()), color, 0, thickness);
    }
}

/// The luminance of A, B and the truth of A's model along a line that can be dragged through the pictures.
class ProfileTab final : public TabContent {
  public:
    void draw(Session &session, ViewPainter &painter) override;
};

void ProfileTab::draw(Session &session, ViewPainter &painter) {
    const Size size = painter.view(false).size;
    const int row =
        std::clamp(static_cast<int>(session.view.profile_row * size.height), 0, std::max(size.height - 1, 0));
    const std::array rows{painter.row(false, row), painter.row(true, row)};
    const Findings *findings = painter.findings();
    std::array<Curve, 3> curves{curve_of(&rows[0], 0), curve_of(&rows[1], 0),
                                curve_of(findings != nullptr ? findings->sides[0].truth.get() : nullptr, row)};
    double top = 0.05;
    for (const Curve &curve : curves) {
        for (const double value : curve) {
            top = std::isfinite(value) ? std::max(top, value) : top;
        }
    }
    top *= 1.05;
    const std::array colors{ImGui::GetColorU32(side_color(false)), ImGui::GetColorU32(side_color(true)),
                            ImGui::GetColorU32(ImGuiCol_Text)};
    const float em = ImGui::GetFontSize();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const ImVec2 low{corner.x + em * 3, corner.y + em * 1.6F};
    const ImVec2 high{corner.x + room.x - em * 0.5F, corner.y + std::max(room.y - em * 0.5F, em * 4)};
    ImDrawList &list = *ImGui::GetWindowDrawList();
    list.AddRect(low, high, ImGui::GetColorU32(ImGuiCol_Border));
    list.AddText({corner.x, low.y - em * 0.5F}, ImGui::GetColorU32(ImGuiCol_Text), fmt::format("{:.2g}", top).c_str());
    list.AddText({corner.x, high.y - em}, ImGui::GetColorU32(ImGuiCol_Text), "0");
    draw_curve(curves[2], low, high, top, colors[2], em * 0.18F); // the truth lies behind
    draw_curve(curves[0], low, high, top, colors[0], em * 0.11F);
    draw_curve(curves[1], low, high, top, colors[1], em * 0.11F);

    const auto at = session.view.hovered_pixel;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const auto column = at ? static_cast<std::size_t>(at->x * static_cast<double>(curves[i].size())) : 0;
        const std::string value = at && column < curves[i].size() ? fmt::format("  {:.3f}", curves[i][column]) : "";
        const std::string text =
            curves[i].empty() ? fmt::format("{}: not known yet", curve_names[i]) : curve_names[i] + value;
        ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(colors[i]), "%s", text.c_str());
        describe_item(session, curve_names[i], "", text);
        ImGui::SameLine(0, em * 1.5F);
    }
    ImGui::TextColored(quiet_text(), "luminance of row %d; drag the line", row);
    if (at) {
        const float x = low.x + static_cast<float>(at->x) * (high.x - low.x);
        list.AddLine({x, low.y}, {x, high.y}, ImGui::GetColorU32(ImGuiCol_TextDisabled));
    }
}

} // namespace

std::unique_ptr<TabContent> profile_tab(const DrawingSupplies &) { return std::make_unique<ProfileTab>(); }

} // namespace sandbox

#include "ui/tabs/motion_strip.h"

#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <imgui.h>
#include <string>

namespace sandbox {

namespace {

std::array<Label, 3> curve_labels(const Session &session) { return {"A", "B", session.label("truth")}; }

struct Frame2d {
    ImVec2 low, high;
    int moments = 2;
    double top = 1;
    [[nodiscard]] float x(int moment) const {
        return low.x + (high.x - low.x) * static_cast<float>(moment) / static_cast<float>(moments);
    }
    [[nodiscard]] float y(double value) const {
        return high.y - static_cast<float>(std::clamp(value / top, 0.0, 1.0)) * (high.y - low.y);
    }
};

/// The first value belongs to moment 1.
void draw_curve(const std::vector<double> &curve, const Frame2d &frame, ImU32 color, float thickness) {
    std::vector<ImVec2> points;
    for (std::size_t i = 0; i < curve.size(); ++i) {
        points.emplace_back(frame.x(static_cast<int>(i) + 1), frame.y(curve[i]));
    }
    ImGui::GetWindowDrawList()->AddPolyline(points.data(), static_cast<int>(points.size()), color, 0, thickness);
}

std::string curve_text(const Session &session, const Changes &changes, std::size_t i, const std::string &name) {
    const std::vector<double> &curve = changes.curves[i];
    const auto moment = static_cast<std::size_t>(session.playback.moment);
    if (session.playback.shown && moment > 0 && moment <= curve.size()) {
        return fmt::format("{} {:.3f}", name, curve[moment - 1]);
    }
    return curve.empty() ? name : session.text("motion.up_to", name, std::ranges::max(curve));
}

} // namespace

void motion_strip(Session &session, const Changes &changes) {
    const float em = ImGui::GetFontSize();
    const std::array colors{ImGui::GetColorU32(side_color(false)), ImGui::GetColorU32(side_color(true)),
                            ImGui::GetColorU32(ImGuiCol_Text)};
    Frame2d frame;
    frame.moments = moments_of(changes.motion);
    frame.top = 0.01;
    for (const auto &curve : changes.curves) {
        frame.top = curve.empty() ? frame.top : std::max(frame.top, std::ranges::max(curve) * 1.05);
    }
    const std::size_t done = changes.curves[0].size() + 1;
    std::string what = session.text("motion.change", changes.size.width, changes.size.height);
    what += static_cast<int>(done) < frame.moments ? session.text("motion.progress", done, frame.moments) : "";
    ImGui::TextColored(quiet_text(), "%s", what.c_str());
    const std::array<Label, 3> labels = curve_labels(session);
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const std::string text = curve_text(session, changes, i, labels[i].shown);
        same_line_if_fits(ImGui::CalcTextSize(text.c_str()).x);
        ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(colors[i]), "%s", text.c_str());
        describe_item(session, labels[i].name, session.text("motion.change.help"), text);
    }
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 room = ImGui::GetContentRegionAvail();
    frame.low = {corner.x + em * 3, corner.y + em * 0.3F};
    frame.high = {corner.x + std::max(room.x, em * 6) - em * 0.5F, corner.y + std::max(room.y - em * 0.5F, em * 3)};
    ImGui::SetCursorScreenPos(frame.low);
    ImGui::InvisibleButton("strip", {frame.high.x - frame.low.x, frame.high.y - frame.low.y});
    if (ImGui::IsItemActive()) {
        const float share = (ImGui::GetMousePos().x - frame.low.x) / (frame.high.x - frame.low.x);
        const int wanted =
            std::clamp(static_cast<int>(share * static_cast<float>(frame.moments)), 0, frame.moments - 1);
        step_motion(session, wanted - session.playback.moment);
    }
    describe_item(session, "strip", session.text("motion.strip.help"));
    ImDrawList &list = *ImGui::GetWindowDrawList();
    list.AddRect(frame.low, frame.high, ImGui::GetColorU32(ImGuiCol_Border));
    list.AddText({corner.x, frame.low.y - em * 0.3F}, colors[2], fmt::format("{:.2g}", frame.top).c_str());
    list.AddText({corner.x, frame.high.y - em}, colors[2], "0");
    draw_curve(changes.curves[2], frame, colors[2], em * 0.2F); // the truth lies behind
    draw_curve(changes.curves[0], frame, colors[0], em * 0.11F);
    draw_curve(changes.curves[1], frame, colors[1], em * 0.11F);
    if (session.playback.shown) {
        const float x = frame.x(session.playback.moment);
        list.AddLine({x, frame.low.y}, {x, frame.high.y}, ImGui::GetColorU32(ImGuiCol_SliderGrab), 2);
    }
}

} // namespace sandbox

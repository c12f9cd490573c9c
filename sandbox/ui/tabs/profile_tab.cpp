#include "ui/tabs/bottom_tabs.h"

#include "capture/picture.h"
#include "image/error.h"
#include "measure/metrics/profile.h"
#include "reference/term_shares.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <fmt/format.h>
#include <imgui.h>
#include <string>
#include <string_view>

namespace sandbox {

namespace {

using Curves = std::array<Curve, 3>; ///< of A, B and the truth

Curve curve_of(const Image *image, int row) { return image != nullptr ? luminance_row(*image, row) : Curve{}; }

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

/// A term along a row.
struct TermAsked {
    SidesShown shown;
    int row = 0;
    std::string_view term; ///< of term_names
    bool operator==(const TermAsked &) const = default;
};

/// Of A, B and the truth of A's model; a technique that is refused has none, and its view says why.
void work_out(const TermAsked &asked, const SideResources &resources, const JobReporter &reporter, Curves &curves) {
    for (std::size_t i = 0; i < curves.size() && !reporter.cancelled(); ++i) {
        const bool right = i == 1;
        const Technique technique = i == 2  ? asked.shown.truth_of_side(false)
                                    : right ? asked.shown.right
                                            : asked.shown.left;
        try {
            for (const glm::dvec3 &color : term_row(asked.shown.scene_of(right), resources[right ? 1 : 0], technique,
                                                    asked.shown.size, asked.row, asked.term)) {
                curves[i].push_back(luminance(color));
            }
        } catch (const InputError &) {
            curves[i].clear();
        }
    }
}

/// The luminance of A, B and the truth of A's model, or one term of it, along a line that can be dragged through the
/// pictures.
class ProfileTab final : public TabContent {
  public:
    void draw(Session &session, ViewPainter &painter) override;
    News take_news(Session &session) override;
    [[nodiscard]] bool busy() const override { return job_ != nullptr; }

  private:
    void choose_term(Session &session);
    void ask(const Session &session, ViewPainter &painter, const TermAsked &wanted);
    [[nodiscard]] Curves curves(const Session &session, ViewPainter &painter, int row);

    std::string_view term_; ///< empty: the colour, as drawn
    std::optional<TermAsked> asked_;
    std::shared_ptr<Curves> found_;      ///< of asked_, once the job has ended
    std::unique_ptr<BackgroundJob> job_; ///< while one runs; last: ends before what it writes to
};

News ProfileTab::take_news(Session &) {
    const News news = job_ ? job_->take_news() : News::none;
    if (news == News::result) {
        job_.reset();
    }
    return news;
}

void ProfileTab::choose_term(Session &session) {
    const bool highlights =
        reflection(session.document.left.model).specular || reflection(session.document.right.model).specular;
    term_ = !highlights && term_ == term_names[2] ? "" : term_;
    if (toggle_button(session, session.label("profile.colour"), term_.empty(), session.text("profile.colour.help"))) {
        term_ = "";
    }
    for (const std::string_view term : term_names) {
        if (term == term_names[2] && !highlights) {
            continue;
        }
        ImGui::SameLine(0, 2);
        if (toggle_button(session, session.label(fmt::format("term.{}", term)), term_ == term,
                          session.text("profile.term.help"))) {
            term_ = term;
        }
    }
}

/// In the background, while nothing is dragged; what is out of date is stopped.
void ProfileTab::ask(const Session &session, ViewPainter &painter, const TermAsked &wanted) {
    if (asked_ == wanted || wanted.shown.size.width == 0) {
        return;
    }
    found_.reset();
    asked_.reset();
    if (job_) {
        job_->cancel(); // its end wakes the window
        return;
    }
    if (ImGui::IsAnyItemActive() || session.playback.playing) {
        return;
    }
    asked_ = wanted;
    try {
        job_ = std::make_unique<BackgroundJob>(
            [wanted, found = found_ = std::make_shared<Curves>(), resources = painter.resources_of(wanted.shown)](
                JobReporter &reporter) { work_out(wanted, resources, reporter, *found); },
            wake_window);
    } catch (const std::exception &) {
        found_.reset(); // the view shows the error
    }
}

Curves ProfileTab::curves(const Session &session, ViewPainter &painter, int row) {
    if (!term_.empty()) {
        ask(session, painter, {painter.sides_shown(shown_document(session)), row, term_});
        return found_ && !job_ ? *found_ : Curves{};
    }
    const std::array rows{painter.row(false, row), painter.row(true, row)};
    const Findings *findings = painter.findings();
    return {curve_of(&rows[0], 0), curve_of(&rows[1], 0),
            curve_of(findings != nullptr ? findings->sides[0].truth.get() : nullptr, row)};
}

void ProfileTab::draw(Session &session, ViewPainter &painter) {
    choose_term(session);
    const Size size = painter.view(false).size;
    const int row =
        std::clamp(static_cast<int>(session.view.profile_row * size.height), 0, std::max(size.height - 1, 0));
    const Curves curves = this->curves(session, painter, row);
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
    const auto at = session.view.hovered_pixel;
    const std::array<Label, 3> labels{"A", "B", session.label("truth")};
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const auto column = at ? static_cast<std::size_t>(at->x * static_cast<double>(curves[i].size())) : 0;
        const std::string value = at && column < curves[i].size() ? fmt::format("  {:.3f}", curves[i][column]) : "";
        const std::string text =
            curves[i].empty() ? session.text("profile.unknown", labels[i].shown) : labels[i].shown + value;
        same_line_if_fits(ImGui::CalcTextSize(text.c_str()).x);
        ImGui::AlignTextToFramePadding();
        ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(colors[i]), "%s", text.c_str());
        describe_item(session, labels[i].name, "", text);
    }
    const std::string what = term_.empty()
                                 ? session.text("profile.row", row)
                                 : session.text("profile.term_row", session.text(fmt::format("term.{}", term_)), row);
    same_line_if_fits(ImGui::CalcTextSize(what.c_str()).x);
    ImGui::TextColored(quiet_text(), "%s", what.c_str());
    describe_item(session, "what", "", what);

    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const ImVec2 low{corner.x + em * 3, corner.y + em * 0.5F};
    const ImVec2 high{corner.x + room.x - em * 0.5F, corner.y + std::max(room.y - em * 0.5F, em * 4)};
    ImDrawList &list = *ImGui::GetWindowDrawList();
    list.AddRect(low, high, ImGui::GetColorU32(ImGuiCol_Border));
    list.AddText({corner.x, low.y - em * 0.5F}, ImGui::GetColorU32(ImGuiCol_Text), fmt::format("{:.2g}", top).c_str());
    list.AddText({corner.x, high.y - em}, ImGui::GetColorU32(ImGuiCol_Text), "0");
    list.PushClipRect(low, high, true);
    draw_curve(curves[2], low, high, top, colors[2], em * 0.18F); // the truth lies behind
    draw_curve(curves[0], low, high, top, colors[0], em * 0.11F);
    draw_curve(curves[1], low, high, top, colors[1], em * 0.11F);
    list.PopClipRect();
    if (at) {
        const float x = low.x + static_cast<float>(at->x) * (high.x - low.x);
        list.AddLine({x, low.y}, {x, high.y}, ImGui::GetColorU32(ImGuiCol_TextDisabled));
    }
}

} // namespace

std::unique_ptr<TabContent> profile_tab(const DrawingSupplies &) { return std::make_unique<ProfileTab>(); }

} // namespace sandbox

#include "ui/tabs/bottom_tabs.h"

#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <algorithm>
#include <array>
#include <exception>
#include <fmt/format.h>
#include <imgui.h>
#include <string>

namespace sandbox {

namespace {

/// Every intermediate of the pixel under the mouse, or of the one that a click has pinned.
class PixelProbeTab final : public TabContent {
  public:
    void follow(Session &session, ViewPainter &painter) override;
    void draw(Session &session, ViewPainter &painter) override;
    News take_news(Session &session) override;
    [[nodiscard]] bool busy() const override { return job_ != nullptr; }

  private:
    struct Place {
        SidesShown shown;
        int x = 0, y = 0;
        bool operator==(const Place &) const = default;
    };
    void table(Session &session, const PixelFindings &found);

    std::optional<Place> probed_; ///< what the job was asked last
    std::shared_ptr<PixelFindings> found_;
    std::unique_ptr<BackgroundJob> job_; ///< while one runs; last: ends before what it writes to
};

News PixelProbeTab::take_news(Session &session) {
    const News news = job_ ? job_->take_news() : News::none;
    if (news == News::result) {
        session.pixel = job_->state() == JobState::done ? found_ : nullptr;
        job_.reset();
    }
    if (session.view.overlay != Overlay::pixel) {
        session.pixel.reset();
        probed_.reset();
    }
    return news;
}

void PixelProbeTab::follow(Session &session, ViewPainter &painter) {
    const auto at = session.view.probed();
    if (!at) {
        return;
    }
    Place place{painter.sides_shown(shown_document(session)), 0, 0};
    place.x = std::min(static_cast<int>(at->x * place.shown.size.width), place.shown.size.width - 1);
    place.y = std::min(static_cast<int>(at->y * place.shown.size.height), place.shown.size.height - 1);
    if (probed_ == place || job_ || place.shown.size.width == 0) {
        return; // a running job ends soon, and then what is wanted by then is probed
    }
    probed_ = place;
    found_ = std::make_shared<PixelFindings>();
    try {
        job_ = std::make_unique<BackgroundJob>(
            [place, found = found_, resources = painter.resources_of(place.shown)](JobReporter &) {
                *found = probe_sides(place.shown, resources, place.x, place.y);
            },
            wake_window);
    } catch (const std::exception &) {
        session.pixel.reset(); // the view shows the error
    }
}

void PixelProbeTab::table(Session &session, const PixelFindings &found) {
    const bool two_truths = !found.of.one_truth();
    const int columns = two_truths ? 5 : 4;
    constexpr ImGuiTableFlags flags = ImGuiTableFlags_ScrollX | ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg |
                                      ImGuiTableFlags_BordersInnerV | ImGuiTableFlags_SizingFixedFit;
    if (!ImGui::BeginTable("probe", columns, flags)) {
        return;
    }
    ImGui::TableSetupScrollFreeze(1, 1);
    ImGui::TableSetupColumn("");
    ImGui::TableSetupColumn("A");
    ImGui::TableSetupColumn("B");
    ImGui::TableSetupColumn(session.text(two_truths ? "probe.truth_of_a" : "truth").c_str());
    if (two_truths) {
        ImGui::TableSetupColumn(session.text("probe.truth_of_b").c_str());
    }
    ImGui::TableHeadersRow();
    for (const ProbeRow &row : probe_rows(session.words, found)) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextColored(quiet_text(), "%s", row.title.shown.c_str());
        for (std::size_t side = 0; side + 1 < static_cast<std::size_t>(columns); ++side) {
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(row.values[side].c_str());
            describe_item(session,
                          fmt::format("{}/{}", std::array{"A", "B", "truth", "truth of B"}[side], row.title.name), "",
                          row.values[side]);
        }
    }
    ImGui::EndTable();
}

void PixelProbeTab::draw(Session &session, ViewPainter &) {
    const PixelFindings *found = session.pixel.get();
    if (found == nullptr || !(*found)[Probed::truth_of_a]) {
        wrapped_text(quiet_text(), session.text(found == nullptr ? "probe.about" : "probe.background"));
        return;
    }
    if (button(session, session.label("copy"), session.text("probe.copy.help"))) {
        ImGui::SetClipboardText(probe_text(session.words, *found).c_str());
        session.message = {session.text("message.copied"), false};
    }
    for (const bool right : {false, true}) {
        const auto &side = (*found)[right ? Probed::b : Probed::a];
        const auto &truth = (*found)[right ? Probed::truth_of_b : Probed::truth_of_a];
        const std::string worst = side && truth ? worst_term(session.words, *side, *truth) : "";
        const std::string text = !side           ? session.text("probe.no_terms")
                                 : worst.empty() ? session.text("probe.right")
                                                 : worst;
        if (right) {
            same_line_if_fits(ImGui::CalcTextSize(text.c_str()).x + ImGui::GetFontSize() * 2);
        } else {
            ImGui::SameLine();
        }
        ImGui::TextColored(side_color(right), "%s", right ? "B" : "A");
        ImGui::SameLine();
        ImGui::TextUnformatted(text.c_str());
        describe_item(session, right ? "B/worst" : "A/worst", "", text);
    }
    table(session, *found);
}

} // namespace

std::unique_ptr<TabContent> pixel_probe_tab(const DrawingSupplies &) { return std::make_unique<PixelProbeTab>(); }

} // namespace sandbox

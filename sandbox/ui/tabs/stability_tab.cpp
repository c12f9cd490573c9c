#include "ui/tabs/bottom_tabs.h"

#include "measure/report/stability_report.h"
#include "reference/reference.h"
#include "ui/jobs/stability_job.h"
#include "ui/session/written_files.h"
#include "ui/tabs/stability_details.h"
#include "ui/tabs/stability_table.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"
#include "words/row_words.h"

#include <algorithm>
#include <exception>
#include <fmt/format.h>
#include <imgui.h>

namespace sandbox {

namespace {

/// The stiff and extreme cases: run here as the command `stability` runs them, opened with a click.
class StabilityTab final : public TabContent {
  public:
    explicit StabilityTab(const DrawingSupplies &supplies)
        : supplies_(supplies), cases_(list_cases(stability_cases())), groups_(groups_of(cases_)) {
        groups_.insert(groups_.begin(), ""); // all
    }
    void draw(Session &session, ViewPainter &painter) override;
    News take_news(Session &session) override;
    [[nodiscard]] bool busy() const override { return job_ != nullptr; }

  private:
    void start(bool all);
    void take_finished();
    void finish(Session &session);
    void open(Session &session, ViewPainter &painter, std::size_t number);
    void export_files(Session &session) const;

    void run_buttons(Session &session);
    void filter_controls(Session &session);
    void story(const Session &session, ImVec2 size);

    DrawingSupplies supplies_;
    std::vector<ListedCase> cases_;
    std::vector<std::string> groups_; ///< the first: all
    std::size_t group_ = 0;
    CaseFilter filter_;
    std::optional<std::size_t> chosen_;
    std::optional<Document> before_;    ///< what was open before the first click on a case
    std::unique_ptr<StabilityJob> job_; ///< while one runs
    StabilityDetails details_;
    std::string failure_;
};

bool shows_a_case(const Session &session, const std::vector<ListedCase> &cases) {
    return std::ranges::find(cases, session.document.opened->name, &ListedCase::name) != cases.end();
}

void StabilityTab::start(bool all) {
    std::vector<StabilityCase> wanted;
    for (std::size_t i = 0; i < cases_.size(); ++i) {
        if (all || i == chosen_) {
            wanted.push_back(cases_[i].definition);
        }
    }
    try {
        failure_.clear();
        job_ = std::make_unique<StabilityJob>(supplies_, std::move(wanted));
    } catch (const std::exception &error) {
        failure_ = error.what();
    }
}

void StabilityTab::take_finished() {
    for (StabilityResult &result : job_->take_finished()) {
        const auto listed = std::ranges::find(cases_, result.definition.name, &ListedCase::name);
        listed->result = std::move(result);
        details_.forget();
    }
}

News StabilityTab::take_news(Session &session) {
    const News news = job_ ? job_->job().take_news() : News::none;
    if (news != News::none) {
        take_finished();
    }
    if (news == News::result) {
        finish(session);
    }
    return news;
}

/// Says how the job ended.
void StabilityTab::finish(Session &session) {
    if (job_->job().state() == JobState::failed) {
        failure_ = session.text("stability.stopped") + job_->job().error();
        session.message = {failure_, true};
    } else {
        session.message = {session.text(job_->job().cancelled() ? "stability.cancelled" : "stability.done",
                                        summary(session.words, cases_)),
                           false};
    }
    job_.reset();
}

/// Known from a run; otherwise found from the reference.
double exposure_of(const ListedCase &listed, ViewPainter &painter) {
    if (listed.result) {
        return listed.result->exposure;
    }
    if (listed.definition.unit == ErrorUnit::linear_color) {
        return 1; // whatever the reference shows, so it need not be drawn
    }
    const Scene &scene = listed.definition.scene;
    const auto resources = painter.renderer().resources().load(scene);
    return stability_exposure(listed.definition,
                              render_reference(scene, resources, listed.definition.techniques.front(), stability_size));
}

/// The case's scene in the views, as one step that can be undone.
void StabilityTab::open(Session &session, ViewPainter &painter, std::size_t number) {
    attempt(session, "", [&] {
        const Document document = case_document(cases_[number].definition, exposure_of(cases_[number], painter));
        if (!shows_a_case(session, cases_)) {
            before_ = session.document;
        }
        show_document(session, document);
        chosen_ = number;
        details_.forget();
    });
}

void StabilityTab::export_files(Session &session) const {
    attempt(session, session.text("message.not_exported"), [&] {
        const StabilityRun run{results_of(cases_), supplies_.by.renderer, SANDBOX_VERSION, session.words};
        const bool all = run.results.size() == cases_.size();
        session.message = {
            session.text(all ? "stability.exported" : "stability.exported_some", export_stability(run).string()),
            false};
    });
}

void StabilityTab::run_buttons(Session &session) {
    if (button(session, session.label("stability.run_all"), session.text("stability.run_all.help"))) {
        start(true);
    }
    ImGui::SameLine();
    ImGui::BeginDisabled(!chosen_);
    if (button(session, session.label("stability.run"), session.text("stability.run.help"))) {
        start(false);
    }
    ImGui::EndDisabled();
    ImGui::SameLine();
    const bool any = std::ranges::any_of(cases_, [](const ListedCase &listed) { return listed.result.has_value(); });
    ImGui::BeginDisabled(!any);
    if (button(session, session.label("export"), session.text("stability.export.help"))) {
        export_files(session);
    }
    ImGui::EndDisabled();
}

void StabilityTab::filter_controls(Session &session) {
    const float em = ImGui::GetFontSize();
    same_line_if_fits(em * 9);
    ImGui::SetNextItemWidth(em * 9);
    std::vector<Label> groups;
    for (const std::string &group : groups_) {
        groups.push_back(group.empty() ? session.label("stability.all_groups")
                                       : Label(file_text(session.words, group), group));
    }
    if (combo(session, "group", groups, group_, session.text("stability.group.help"))) {
        filter_.group = group_ == 0 ? "" : groups_[group_];
    }
    same_line_if_fits(em * 10);
    checkbox(session, session.label("stability.filter"), filter_.textbook_breaks,
             session.text("stability.filter.help"));
    if (before_ && shows_a_case(session, cases_)) {
        const Label back = session.label("stability.back", before_->opened->name);
        same_line_if_fits(button_width(back.shown));
        if (button(session, back, session.text("stability.back.help"))) {
            show_document(session, *before_);
            before_.reset();
        }
    }
}

void StabilityTab::story(const Session &session, ImVec2 size) {
    if (ImGui::BeginChild("story", size)) {
        if (std::ranges::none_of(cases_, [this](const ListedCase &listed) { return is_shown(listed, filter_); })) {
            wrapped_text(ImGui::GetStyleColorVec4(ImGuiCol_Text), session.text("stability.no_match"));
        }
        if (chosen_) {
            details_.draw(session, cases_[*chosen_]);
        } else {
            wrapped_text(quiet_text(), summary(session.words, cases_));
            wrapped_text(quiet_text(), session.text("stability.about"));
        }
    }
    ImGui::EndChild();
}

void StabilityTab::draw(Session &session, ViewPainter &painter) {
    if (job_) {
        job_progress_row(session, job_->job());
    } else {
        run_buttons(session);
        filter_controls(session);
    }
    if (!failure_.empty()) {
        wrapped_text(error_text(), failure_);
    }
    const float em = ImGui::GetFontSize();
    const ImVec2 gap = ImGui::GetStyle().ItemSpacing;
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const bool beside = room.x > em * 46;
    const float width = beside ? std::clamp(room.x * 0.4F, em * 27.5F, em * 34) : room.x; // of the story
    const float height = beside ? room.y : room.y * (chosen_ ? 0.5F : 0.2F);
    const ImVec2 table = beside ? ImVec2{room.x - width - gap.x, room.y} : ImVec2{room.x, room.y - height - gap.y};
    if (const auto clicked = case_table(session, cases_, filter_, chosen_, table)) {
        open(session, painter, *clicked);
    }
    if (beside) {
        ImGui::SameLine();
    }
    story(session, {width, height});
}

} // namespace

std::unique_ptr<TabContent> stability_tab(const DrawingSupplies &supplies) {
    return std::make_unique<StabilityTab>(supplies);
}

} // namespace sandbox

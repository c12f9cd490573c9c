#include "ui/tabs/bottom_tabs.h"

#include "ui/jobs/measured_rows.h"
#include "ui/jobs/report_job.h"
#include "ui/session/written_files.h"
#include "ui/tabs/error_time_view.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <algorithm>
#include <exception>
#include <fmt/format.h>
#include <utility>

namespace sandbox {

namespace {

/// Runs the measurement that the command `report` runs, and shows what it found.
class ErrorTimeTab final : public TabContent {
  public:
    explicit ErrorTimeTab(const DrawingSupplies &supplies) : supplies_(supplies) {}
    void draw(Session &session, ViewPainter &painter) override;
    News take_news(Session &session) override;
    [[nodiscard]] bool busy() const override { return job_ != nullptr || estimating_ != nullptr; }

  private:
    void start(Session &session);
    void estimate(const Session &session, const ViewPainter &painter);
    void show_estimate(Session &session) const;
    void finish(Session &session);
    void show_measured_model(const WorkPrecision &measured, Model wished);
    void controls(Session &session);
    void findings(Session &session);
    void facts(const Session &session) const;

    DrawingSupplies supplies_;
    bool quick_ = true;
    ErrorTimeView view_;
    std::unique_ptr<ReportJob> job_; ///< while one runs
    std::string running_name_;       ///< of the scene that the job measures
    std::optional<ReportRun> run_;   ///< the last one that brought any row
    std::string name_;               ///< of its scene
    std::string failure_;
    std::optional<std::pair<Scene, bool>>
        estimated_; ///< the scene that seconds_ is of, and whether it is a quick run's
    std::optional<double> seconds_;
    std::unique_ptr<CostJob> estimating_; ///< while one runs
};

void ErrorTimeTab::start(Session &session) {
    try {
        failure_.clear();
        if (estimating_) {
            estimating_->job().cancel(); // its end wakes the window
            estimated_.reset();
        }
        running_name_ = session.document.opened->name;
        job_ = start_report(supplies_, session.document.scene, quick_, session.words);
    } catch (const std::exception &error) {
        failure_ = error.what();
    }
}

News ErrorTimeTab::take_news(Session &session) {
    const News news = job_ ? job_->job().take_news() : News::none;
    if (news == News::result) {
        finish(session);
    }
    const News estimate = estimating_ ? estimating_->job().take_news() : News::none;
    if (estimate == News::result) {
        if (estimating_->job().state() == JobState::done && !estimating_->job().cancelled()) {
            seconds_ = estimating_->take_result();
        }
        estimating_.reset();
    }
    return std::max(news, estimate);
}

/// Once a scene and kind of run, when all else about the scene has been found out.
void ErrorTimeTab::estimate(const Session &session, const ViewPainter &painter) {
    const Findings *findings = painter.findings();
    const std::pair wanted(session.document.scene, quick_);
    if (!session.appearance.run_times || findings == nullptr || !findings->sides[1].time || estimated_ == wanted) {
        return;
    }
    seconds_.reset();
    if (estimating_) {
        estimating_->job().cancel(); // its end wakes the window
        return;
    }
    estimated_ = wanted;
    try {
        estimating_ = start_estimate(supplies_, wanted.first, quick_);
    } catch (const std::exception &) {
        return; // a run says why
    }
}

void ErrorTimeTab::show_estimate(Session &session) const {
    const bool known = session.appearance.run_times && estimated_ == std::pair(session.document.scene, quick_);
    const std::string text = !known        ? ""
                             : seconds_    ? about_seconds(session.words, *seconds_)
                             : estimating_ ? session.text("error_time.estimating")
                                           : "";
    if (!text.empty()) {
        ImGui::SameLine();
        ImGui::AlignTextToFramePadding();
        ImGui::TextColored(quiet_text(), "%s", text.c_str());
        describe_item(session, "estimate", session.text("error_time.estimate.help"), text);
    }
}

/// Keeps the result of the job, which has ended.
void ErrorTimeTab::finish(Session &session) {
    if (job_->job().state() == JobState::failed) {
        failure_ = session.text("error_time.not_measured") + job_->job().error();
        session.message = {failure_, true};
    } else if (auto run = job_->take_result(); run && complete_rows(run->measured) > 0) {
        const bool finished = run->measured.finished;
        show_measured_model(run->measured, run_ ? view_.model : session.document.right.model);
        run_ = std::move(run);
        name_ = running_name_;
        session.message = {session.text(finished ? "error_time.measured" : "error_time.cancelled"), false};
    } else {
        session.message = {session.text("error_time.cancelled_early"), false};
    }
    job_.reset();
}

/// Scenes without highlights have rows of one model alone.
void ErrorTimeTab::show_measured_model(const WorkPrecision &measured, Model wished) {
    const std::vector<Model> models = models_of(measured);
    view_.model = std::ranges::find(models, wished) != models.end() ? wished : models.back();
}

void ErrorTimeTab::controls(Session &session) {
    if (toggle_button(session, session.label("error_time.quick"), quick_, session.text("error_time.quick.help"))) {
        quick_ = true;
    }
    ImGui::SameLine(0, 2);
    if (toggle_button(session, session.label("error_time.full"), !quick_, session.text("error_time.full.help"))) {
        quick_ = false;
    }
    ImGui::SameLine();
    if (button(session, session.label("error_time.run"), session.text("error_time.run.help"))) {
        start(session);
    }
    show_estimate(session);
    if (run_) {
        ImGui::SameLine();
        if (button(session, session.label("export"), session.text("error_time.export.help"))) {
            attempt(session, session.text("message.not_exported"), [&] {
                session.message = {session.text("message.exported", export_report(*run_, name_).string()), false};
            });
        }
    }
}

/// How the numbers were taken.
void ErrorTimeTab::facts(const Session &session) const {
    const WorkPrecision &m = run_->measured;
    wrapped_text(quiet_text(), session.text("error_time.facts", name_, m.options.size.width, m.options.size.height,
                                            complete_rounds(m), run_->machine.clock, run_->machine.renderer));
    wrapped_text(quiet_text(), session.text("error_time.rings"));
}

void ErrorTimeTab::findings(Session &session) {
    const WorkPrecision &m = run_->measured;
    const float em = ImGui::GetFontSize();
    const bool beside = ImGui::GetContentRegionAvail().x > em * 46;
    const float table = em * 21;
    if (!job_ && beside) {
        ImGui::SameLine();
    }
    error_time_choices(session, m, view_, !beside);
    if (beside) {
        error_time_legend(session, view_);
    }
    const ImVec2 room = ImGui::GetContentRegionAvail();
    error_time_figure(session, m, view_, {beside ? room.x - table : room.x, std::max(room.y, em * 7.5F)});
    if (beside) {
        ImGui::SameLine();
    } else {
        error_time_legend(session, view_);
    }
    ImGui::BeginGroup();
    cheapest_table(session, m, view_);
    ImGui::Spacing();
    facts(session);
    ImGui::EndGroup();
}

void ErrorTimeTab::draw(Session &session, ViewPainter &painter) {
    if (!job_) {
        estimate(session, painter);
    }
    if (job_) {
        job_progress_row(session, job_->job());
    } else {
        controls(session);
    }
    if (!failure_.empty()) {
        wrapped_text(error_text(), failure_);
    }
    if (run_) {
        findings(session);
    } else {
        wrapped_text(quiet_text(), session.text("error_time.about", supplies_.by.renderer));
    }
}

} // namespace

std::unique_ptr<TabContent> error_time_tab(const DrawingSupplies &supplies) {
    return std::make_unique<ErrorTimeTab>(supplies);
}

} // namespace sandbox

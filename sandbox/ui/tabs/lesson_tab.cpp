#include "ui/jobs/claims_job.h"
#include "ui/tabs/bottom_tabs.h"
#include "ui/tabs/claim_list.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <algorithm>
#include <exception>
#include <fmt/format.h>
#include <imgui.h>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace sandbox {

namespace {

/// From the left: the steps, the step's text, its claims.
enum class Columns { text_over_claims, text_and_claims, all };
Columns columns_for(float ems) {
    return ems >= 75 ? Columns::all : ems >= 45 ? Columns::text_and_claims : Columns::text_over_claims;
}
constexpr float contents_ems = 15;
constexpr float claims_share = 0.37F; // of the text's and the claims' width

class LessonTab final : public TabContent {
  public:
    explicit LessonTab(DrawingSupplies supplies) : supplies_(std::move(supplies)) {}
    void follow(Session &session, ViewPainter &painter) override;
    void draw(Session &session, ViewPainter &painter) override;
    News take_news(Session &session) override;
    [[nodiscard]] bool busy() const override { return job_ != nullptr; }

  private:
    void claims(Session &session, const ShownStep &shown);

    DrawingSupplies supplies_;
    std::shared_ptr<const Lesson> lesson_; ///< that `measured_` is about
    std::map<std::size_t, std::vector<ClaimResult>> measured_;
    std::map<std::size_t, std::string> failures_; ///< of steps that could not be measured
    std::shared_ptr<const ShownStep> measures_;   ///< the job's
    std::unique_ptr<ClaimsJob> job_;              ///< while one runs; last: ends before what it uses
};

bool same_step(const std::shared_ptr<const ShownStep> &a, const std::shared_ptr<const ShownStep> &b) {
    return a && b && a->lesson == b->lesson && a->number == b->number;
}

std::string step_title(const Lesson &lesson, std::size_t number) {
    return fmt::format("{}  {}", number + 1, lesson.steps[number].title.text);
}

bool has_seen(const Session &session, const ShownStep &shown, std::size_t number) {
    const auto seen = session.progress.seen.find(shown.id);
    return seen != session.progress.seen.end() && seen->second.contains(number);
}

/// The steps that have been seen are quieter.
void contents(Session &session, const ShownStep &shown) {
    for (std::size_t i = 0; i < shown.lesson->steps.size(); ++i) {
        const bool current = i == shown.number;
        ImGui::PushStyleColor(ImGuiCol_Text, !current && has_seen(session, shown, i)
                                                 ? quiet_text()
                                                 : ImGui::GetStyleColorVec4(ImGuiCol_Text));
        if (ImGui::Selectable(step_title(*shown.lesson, i).c_str(), current) && !current) {
            go_to_step(session, i);
        }
        ImGui::PopStyleColor();
        describe_item(session, fmt::format("step {}", i + 1), session.text("lesson_tab.step.help"),
                      current ? "current" : "");
    }
}

/// In place of contents() where there is little room.
void contents_list(Session &session, const ShownStep &shown) {
    std::vector<Label> titles;
    for (std::size_t i = 0; i < shown.lesson->steps.size(); ++i) {
        titles.emplace_back(step_title(*shown.lesson, i));
    }
    std::size_t chosen = shown.number;
    ImGui::SetNextItemWidth(std::min(ImGui::GetFontSize() * contents_ems, ImGui::GetContentRegionAvail().x));
    if (combo(session, "steps", titles, chosen, session.text("lesson_tab.steps.help"))) {
        go_to_step(session, chosen);
    }
}

/// A row: back and on, where we are, and what may be done about it.
void head(Session &session, const ShownStep &shown, bool with_contents) {
    const std::size_t count = shown.lesson->steps.size();
    const Label end = session.label("lesson_tab.end");
    for (const auto &[name, steps, usable] :
         {std::tuple("<", -1, shown.number > 0), std::tuple(">", 1, shown.number + 1 < count)}) {
        ImGui::BeginDisabled(!usable);
        if (button(session, name, session.text(steps < 0 ? "lesson_tab.back.help" : "lesson_tab.on.help"))) {
            go_on(session, steps);
        }
        ImGui::EndDisabled();
        ImGui::SameLine(0, 2);
    }
    ImGui::SameLine();
    if (with_contents) {
        contents_list(session, shown);
        ImGui::SameLine();
    }
    const std::string brief = session.text("lesson_tab.place.brief", shown.number + 1, count);
    const std::string place = session.text("lesson_tab.place", brief, shown.lesson->title.text);
    const float rest = ImGui::GetStyle().ItemSpacing.x + button_width(end.shown);
    const bool fits = ImGui::CalcTextSize(place.c_str()).x + rest <= ImGui::GetContentRegionAvail().x;
    ImGui::AlignTextToFramePadding();
    ImGui::TextColored(quiet_text(), "%s", fits ? place.c_str() : brief.c_str());
    describe_item(session, "place", "", place);
    if (step_is_changed(session)) {
        const std::string changed = session.text("lesson_tab.changed");
        const Label restore = session.label("lesson_tab.restore");
        same_line_if_fits(ImGui::CalcTextSize(changed.c_str()).x);
        ImGui::AlignTextToFramePadding();
        ImGui::TextColored(side_color(false), "%s", changed.c_str());
        describe_item(session, "changed", "", changed);
        same_line_if_fits(button_width(restore.shown));
        if (button(session, restore, session.text("lesson_tab.restore.help"))) {
            restore_step(session);
        }
    }
    same_line_if_fits(button_width(end.shown));
    if (button(session, end, session.text("lesson_tab.end.help"))) {
        session.document.step.reset();
    }
}

void question(Session &session, const LessonStep &step) {
    if (!step.question) {
        return;
    }
    ImGui::Spacing();
    large_text(session, "question", step.question->asks.text);
    if (toggle_button(session, session.label("lesson_tab.answer"), session.answer_shown,
                      session.text("lesson_tab.answer.help"))) {
        session.answer_shown = !session.answer_shown;
    }
    if (session.answer_shown) {
        large_text(session, "answer", step.question->answer.text);
    }
}

/// What moves in the step's claims.
void motion(Session &session, const LessonStep &step) {
    if (std::ranges::any_of(step.claims, [](const LessonClaim &claim) { return claim.motion.has_value(); }) &&
        toggle_button(session, session.label("lesson_tab.play"), session.playback.playing,
                      session.text("lesson_tab.play.help"))) {
        play_or_pause(session);
    }
}

void labelled(Session &session, const Label &label, const std::string &text) {
    ImGui::Spacing();
    ImGui::TextColored(quiet_text(), "%s", label.shown.c_str());
    ImGui::SameLine(ImGui::GetFontSize() * 4);
    wrapped_text(ImGui::GetStyleColorVec4(ImGuiCol_Text), text);
    describe_item(session, label.name, "", text);
}

void step_text(Session &session, const ShownStep &shown) {
    const Lesson &lesson = *shown.lesson;
    const LessonStep &step = shown.step();
    ImGui::PushStyleColor(ImGuiCol_Text, side_color(true));
    large_text(session, "title", step.title.text);
    ImGui::PopStyleColor();
    large_text(session, "text", step.text.text);
    motion(session, step);
    question(session, step);
    if (lesson.is_bug()) {
        labelled(session, session.label("lesson_tab.seen"), lesson.seen.text);
        labelled(session, session.label("lesson_tab.cure"), lesson.cure.text);
        labelled(session, session.label("lesson_tab.source"), lesson.source);
    }
}

/// A part of the tab that scrolls by itself.
template <typename Draw> void column(const char *id, float width, Draw draw) {
    if (ImGui::BeginChild(id, {width, 0}, false, ImGuiWindowFlags_NavFlattened)) {
        draw();
    }
    ImGui::EndChild();
}

void choice_among(Session &session, bool bugs) {
    if (bugs) {
        heading(session.text("lesson_tab.bugs"));
    }
    for (const ListedLesson &lesson : session.lessons) {
        if (lesson.bug == bugs) {
            if (ImGui::Selectable(lesson.title.c_str())) {
                session.requests.open_lesson = lesson.name;
            }
            describe_item(session, lesson.name, "", lesson.title);
        }
    }
}

/// All lessons, while none is shown.
void choice(Session &session) {
    const LessonProgress &progress = session.progress;
    if (!progress.last.empty()) {
        const auto listed = std::ranges::find(session.lessons, progress.last, &ListedLesson::name);
        const std::string title = listed != session.lessons.end() ? listed->title : progress.last;
        if (button(session, session.label("lesson_tab.continue"), session.text("lesson_tab.continue.help"))) {
            session.requests.open_lesson = progress.last;
            session.requests.open_step = progress.step;
        }
        ImGui::SameLine();
        ImGui::TextUnformatted(session.text("lesson_tab.where", title, progress.step + 1).c_str());
    }
    wrapped_text(quiet_text(), session.text("lesson_tab.choose"));
    const float room = ImGui::GetContentRegionAvail().x;
    if (columns_for(room / ImGui::GetFontSize()) == Columns::text_over_claims) {
        choice_among(session, false);
        return choice_among(session, true);
    }
    column("lessons", room / 2, [&] { choice_among(session, false); });
    ImGui::SameLine();
    column("bugs", 0, [&] { choice_among(session, true); });
}

} // namespace

std::unique_ptr<TabContent> lesson_tab(const DrawingSupplies &supplies) {
    return std::make_unique<LessonTab>(supplies);
}

void LessonTab::follow(Session &session, ViewPainter &) {
    const auto &shown = session.document.step;
    if (!shown) {
        return;
    }
    if (shown->lesson != lesson_) {
        lesson_ = shown->lesson;
        measured_.clear();
        failures_.clear();
    }
    if (job_) {
        if (!same_step(shown, measures_)) {
            job_->job().cancel(); // its end wakes the window
        }
    } else if (measured_[shown->number].size() < shown->step().claims.size() && !failures_.contains(shown->number)) {
        try {
            measures_ = shown;
            job_ = std::make_unique<ClaimsJob>(supplies_, shown, session.words);
        } catch (const std::exception &error) { // no second OpenGL context
            failures_[shown->number] = error.what();
        }
    }
}

News LessonTab::take_news(Session &) {
    const News news = job_ ? job_->job().take_news() : News::none;
    if (news == News::none) {
        return news;
    }
    const bool of_this_lesson = measures_->lesson == lesson_;
    if (of_this_lesson) {
        measured_[measures_->number] = job_->results();
    }
    if (news == News::result) {
        if (of_this_lesson && job_->job().state() == JobState::failed) {
            failures_[measures_->number] = job_->job().error();
        }
        job_.reset();
    }
    return news;
}

void LessonTab::claims(Session &session, const ShownStep &shown) {
    if (const auto failure = failures_.find(shown.number); failure != failures_.end()) {
        wrapped_text(error_text(), failure->second);
    }
    claim_list(session, shown.step().claims, measured_[shown.number]);
}

void LessonTab::draw(Session &session, ViewPainter &) {
    const auto shown = session.document.step; // held: a click may change it
    if (!shown) {
        return choice(session);
    }
    const float em = ImGui::GetFontSize(), gap = ImGui::GetStyle().ItemSpacing.x;
    const Columns columns = columns_for(ImGui::GetContentRegionAvail().x / em);
    head(session, *shown, columns != Columns::all);
    ScopedId step(shown->number); // each step is read from its top
    if (columns == Columns::all) {
        column("contents", em * contents_ems, [&] { contents(session, *shown); });
        ImGui::SameLine(0, 2 * gap);
    }
    if (columns == Columns::text_over_claims) {
        column("text", 0, [&] {
            step_text(session, *shown);
            claims(session, *shown);
        });
        return;
    }
    const float room = ImGui::GetContentRegionAvail().x;
    column("text", room * (1 - claims_share) - 2 * gap, [&] { step_text(session, *shown); });
    ImGui::SameLine(0, 2 * gap);
    column("claims", 0, [&] { claims(session, *shown); });
}

} // namespace sandbox

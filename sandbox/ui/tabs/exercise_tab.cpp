#include "shading/own_text.h"
#include "teach/marking/sentences.h"
#include "ui/jobs/marking_job.h"
#include "ui/session/own_files.h"
#include "ui/session/shown_exercise.h"
#include "ui/tabs/bottom_tabs.h"
#include "ui/tabs/error_steps.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/verdict_mark.h"
#include "ui/widgets/widgets.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <fmt/format.h>
#include <glm/common.hpp>
#include <imgui.h>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace sandbox {

namespace {

constexpr float beside_ems = 45;    // the least width for the marks beside the task
constexpr float task_share = 0.45F; // of that width

class ExerciseTab final : public TabContent {
  public:
    explicit ExerciseTab(DrawingSupplies supplies) : supplies_(std::move(supplies)) {}
    void follow(Session &session, ViewPainter &painter) override;
    void draw(Session &session, ViewPainter &painter) override;
    News take_news(Session &session) override;
    [[nodiscard]] bool busy() const override { return marker_ != nullptr && marker_->busy(); }

  private:
    void marks(Session &session);
    void term_row(Session &session, const Mark &mark, std::size_t term);
    void head(Session &session, const Mark &mark);

    DrawingSupplies supplies_;
    std::shared_ptr<const Exercise> exercise_; ///< that the marker is of
    std::unique_ptr<ExerciseMarker> marker_;
    OwnShader asked_;            ///< the last text that was given to it
    std::vector<double> errors_; ///< of the texts that were marked, the last one last
    std::size_t hints_ = 2;
};

/// The text that is marked: A's, if A shows own shading.
OwnShader answer_of(const Session &session) {
    return session.document.left.model == Model::own ? session.document.left.own : OwnShader();
}

void list_of_exercises(Session &session, const std::string &shown) {
    for (const ListedExercise &exercise : session.exercises) {
        const ScopedId id(exercise.name);
        const bool solved = session.solved.contains(exercise.name);
        draw_mark(solved ? VerdictMark::tick : VerdictMark::none);
        if (ImGui::Selectable(exercise.title.c_str(), exercise.name == shown)) {
            session.requests.open_exercise = exercise.name;
        }
        describe_item(session, exercise.name, session.text("exercise_tab.open.help"),
                      exercise.title + (solved ? session.text("exercise_tab.is_solved") : ""));
    }
}

/// The one that is shown, and a way to the others.
void exercise_choice(Session &session, const ShownExercise &shown) {
    std::vector<Label> titles;
    std::size_t chosen = session.exercises.size();
    for (const ListedExercise &exercise : session.exercises) {
        const bool solved = session.solved.contains(exercise.name);
        chosen = exercise.name == shown.id ? titles.size() : chosen;
        titles.emplace_back(exercise.title + (solved ? session.text("exercise_tab.is_solved") : ""), exercise.name);
    }
    if (chosen == titles.size()) { // a teacher's own file
        titles.emplace_back(shown.exercise->title.text, shown.id);
    }
    ImGui::SetNextItemWidth(std::min(ImGui::GetFontSize() * 20, ImGui::GetContentRegionAvail().x));
    if (combo(session, "exercises", titles, chosen, session.text("exercise_tab.open.help"))) {
        session.requests.open_exercise = titles[chosen].name;
    }
}

/// What is asked for, and the student's file.
void task(Session &session, const ShownExercise &shown) {
    exercise_choice(session, shown);
    ImGui::PushStyleColor(ImGuiCol_Text, side_color(true));
    large_text(session, "title", shown.exercise->title.text);
    ImGui::PopStyleColor();
    large_text(session, "task", shown.exercise->task.text);
    ImGui::Spacing();
    std::error_code absent;
    const bool written = std::filesystem::exists(shown.file, absent);
    if (button(session, session.label(written ? "exercise_tab.edit" : "exercise_tab.begin"),
               session.text(written ? "exercise_tab.edit.help" : "exercise_tab.begin.help"))) {
        session.requests.begin_exercise = true;
    }
    wrapped_text(quiet_text(), session.text(written ? "exercise_tab.file" : "exercise_tab.no_file", shown.file));
    describe_item(session, "file", "", shown.file);
}

std::string points_text(double points) { return fmt::format("{:.3g}", points); }

/// The largest error of a term in any scene, where it is compared; 0: none was found.
double error_of(const Mark &mark) {
    double largest = 0;
    for (const TermResult &result : mark.judgement.terms) {
        if (result.worst) {
            const glm::dvec3 apart = glm::abs(result.worst->answer - result.worst->truth);
            const double most = std::max({apart.x, apart.y, apart.z});
            largest = std::isfinite(most) ? std::max(largest, most) : INFINITY;
        }
    }
    return largest;
}

} // namespace

std::unique_ptr<TabContent> exercise_tab(const DrawingSupplies &supplies) {
    return std::make_unique<ExerciseTab>(supplies);
}

void ExerciseTab::follow(Session &session, ViewPainter &) {
    const auto shown = session.document.exercise;
    if (!shown) {
        return;
    }
    if (shown->exercise != exercise_) {
        exercise_ = shown->exercise;
        marker_ = std::make_unique<ExerciseMarker>(supplies_, exercise_);
        asked_ = {};
        errors_.clear();
    }
    if (const OwnShader answer = answer_of(session); answer && answer != asked_) {
        asked_ = answer;
        attempt(session, "", [&] { marker_->mark(answer); });
    }
}

News ExerciseTab::take_news(Session &session) {
    const News news = marker_ ? marker_->take_news() : News::none;
    if (news != News::result || !marker_->result() || marker_->result()->text != asked_) {
        return news;
    }
    const Mark &mark = marker_->result()->mark;
    if (mark.refused.empty()) {
        errors_.push_back(error_of(mark));
    }
    const auto shown = session.document.exercise;
    if (shown && shown->exercise == exercise_ && mark.judgement.points(*exercise_) >= exercise_->points() &&
        session.solved.insert(shown->id).second) {
        session.message = {session.text("exercise_tab.solved", exercise_->title.text), false};
    }
    return news;
}

/// The points, and how the error has gone.
void ExerciseTab::head(Session &session, const Mark &mark) {
    const std::string points = session.text("exercise_tab.points", points_text(mark.judgement.points(*exercise_)),
                                            points_text(exercise_->points()));
    large_text(session, "points", points);
    if (marker_->busy()) {
        ImGui::SameLine();
        ImGui::TextColored(quiet_text(), "%s", session.text("exercise_tab.marking").c_str());
    }
    error_steps(session, errors_);
}

/// A tick, or a hint.
void ExerciseTab::term_row(Session &session, const Mark &mark, std::size_t term) {
    const TermResult &result = mark.judgement.terms[term];
    const TermPoints &worth = exercise_->terms[term];
    const std::string title = session.text("exercise_tab.term", title_of(session.words, result.term),
                                           points_text(worth.points * result.share()), points_text(worth.points));
    const std::string hint =
        result.is_right() ? "" : sentence(session.words, *exercise_, mark, result, static_cast<int>(hints_));
    ImGui::BeginGroup();
    draw_mark(result.is_right() ? VerdictMark::tick : VerdictMark::cross);
    ImGui::TextUnformatted(title.c_str());
    if (!hint.empty()) {
        ImGui::Indent(ImGui::GetTextLineHeight() * 1.2F);
        wrapped_text(quiet_text(), hint);
        ImGui::Unindent(ImGui::GetTextLineHeight() * 1.2F);
    }
    ImGui::EndGroup();
    describe_item(session, std::string(term_words[static_cast<std::size_t>(result.term)]), "",
                  title + (result.is_right() ? session.text("exercise_tab.right") : ": " + hint));
}

void ExerciseTab::marks(Session &session) {
    if (!marker_->failure().empty()) {
        wrapped_text(error_text(), marker_->failure());
    }
    if (const std::string failure = own_failure(session, false); !failure.empty()) {
        wrapped_text(error_text(), failure);
    }
    if (!marker_->result()) {
        ImGui::TextColored(quiet_text(), "%s", session.text("exercise_tab.marking").c_str());
        return;
    }
    const Mark &mark = marker_->result()->mark;
    head(session, mark);
    if (!mark.refused.empty()) {
        for (const std::string &why : sentences(session.words, *exercise_, mark, 1)) {
            wrapped_text(error_text(), why);
            describe_item(session, "refused", "", why);
        }
        return;
    }
    std::vector<Label> levels;
    for (int level = 0; level <= most_hints; ++level) {
        levels.push_back(session.label(fmt::format("exercise_tab.hints.{}", level)));
    }
    choice_row(session, session.label("exercise_tab.hints"), levels, hints_, session.text("exercise_tab.hints.help"));
    for (std::size_t term = 0; term < mark.judgement.terms.size(); ++term) {
        term_row(session, mark, term);
    }
}

void ExerciseTab::draw(Session &session, ViewPainter &) {
    const auto shown = session.document.exercise; // held: a click may change it
    if (!shown || shown->exercise != exercise_) {
        wrapped_text(quiet_text(), session.text("exercise_tab.choose"));
        return list_of_exercises(session, "");
    }
    const float room = ImGui::GetContentRegionAvail().x;
    if (room < beside_ems * ImGui::GetFontSize()) {
        task(session, *shown);
        ImGui::Spacing();
        return marks(session);
    }
    const float gap = 2 * ImGui::GetStyle().ItemSpacing.x;
    if (ImGui::BeginChild("task", {room * task_share, 0}, false, ImGuiWindowFlags_NavFlattened)) {
        task(session, *shown);
    }
    ImGui::EndChild();
    ImGui::SameLine(0, gap);
    if (ImGui::BeginChild("marks", {0, 0}, false, ImGuiWindowFlags_NavFlattened)) {
        marks(session);
    }
    ImGui::EndChild();
}

} // namespace sandbox

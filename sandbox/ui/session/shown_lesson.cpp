#include "ui/session/shown_lesson.h"

#include "capture/slide.h"
#include "ui/session/session.h"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <utility>

namespace sandbox {

namespace {

StepView view_of(const LessonStep &step) {
    const PictureOptions slide = slide_options(step);
    return {slide.layout, slide.gain, slide.difference_of, slide.drawn_over};
}

StepView view_of(const ViewSettings &view) { return {view.layout, view.gain, view.difference_of, view.drawn_over}; }

void set_view(ViewSettings &view, const StepView &to) {
    view.layout = to.layout;
    view.gain = to.gain;
    view.difference_of = to.difference_of;
    view.drawn_over = to.drawn_over;
}

Document document_of_step(const Session &session, const ShownStep &shown) {
    const LessonStep &step = shown.step();
    Document document =
        document_of(fmt::format("{}-{:02}", shown.lesson->name, shown.number + 1), step.scene, *step.left, *step.right);
    document.mesh_factors = {step.mesh_factors.x, step.mesh_factors.y};
    document.display = step.display;
    document.exposure = step.exposure;
    document.step =
        std::make_shared<const ShownStep>(ShownStep{shown.lesson, shown.id, shown.number, view_of(session.view)});
    return document;
}

/// What moves in the step's claims can be played.
void offer_motion(Session &session, const LessonStep &step) {
    stop_motion(session);
    const auto moving =
        std::ranges::find_if(step.claims, [](const LessonClaim &claim) { return claim.motion.has_value(); });
    if (moving != step.claims.end()) {
        session.playback.motion = *moving->motion;
    }
}

std::optional<ShownStep> next_step(const Session &session) {
    const auto &shown = session.document.step;
    const bool more = shown && shown->number + 1 < shown->lesson->steps.size();
    return more ? std::optional(ShownStep{shown->lesson, shown->id, shown->number + 1, {}}) : std::nullopt;
}

void show_step(Session &session, const ShownStep &shown) {
    show_document(session, document_of_step(session, shown));
    set_view(session.view, view_of(shown.step()));
    session.view.masks = false; // they would hide the picture
    session.answer_shown = false;
    offer_motion(session, shown.step());
    LessonProgress &progress = session.progress;
    progress.last = shown.id;
    progress.step = shown.number;
    progress.seen[shown.id].insert(shown.number);
}

/// The bug before or behind this one in the gallery; null: none.
const ListedLesson *next_bug(const Session &session, const ShownStep &shown, int steps) {
    const auto &all = session.lessons;
    const auto here = std::ranges::find(all, shown.id, &ListedLesson::name);
    if (here == all.end() || !here->bug || (steps < 0 && here == all.begin()) || (steps > 0 && here + 1 == all.end())) {
        return nullptr;
    }
    const ListedLesson &next = *(steps > 0 ? here + 1 : here - 1);
    return next.bug ? &next : nullptr;
}

} // namespace

void show_step(Session &session, std::shared_ptr<const Lesson> lesson, const std::string &id, std::size_t number) {
    number = std::min(number, lesson->steps.size() - 1);
    show_step(session, ShownStep{std::move(lesson), id, number, {}});
}

void go_to_step(Session &session, std::size_t number) {
    if (const auto shown = session.document.step) {
        show_step(session, shown->lesson, shown->id, number);
    }
}

void go_on(Session &session, int steps) {
    const auto shown = session.document.step;
    if (!shown) {
        return;
    }
    const auto count = static_cast<int>(shown->lesson->steps.size());
    const int next = static_cast<int>(shown->number) + steps;
    const bool beyond = next < 0 || next >= count;
    if (const ListedLesson *bug = beyond ? next_bug(session, *shown, steps) : nullptr) {
        session.requests.open_lesson = bug->name;
        session.requests.open_step = steps < 0 ? std::numeric_limits<std::size_t>::max() : 0; // the last one
        return;
    }
    if (beyond) {
        session.message = {session.text(next < 0 ? "lesson_tab.first" : "lesson_tab.last"), false};
        return;
    }
    go_to_step(session, static_cast<std::size_t>(next));
}

Document next_document(const Session &session) {
    const auto next = next_step(session);
    return next ? document_of_step(session, *next) : session.document;
}

ViewSettings next_view(const Session &session) {
    ViewSettings view = session.view;
    if (const auto next = next_step(session)) {
        set_view(view, view_of(next->step()));
    }
    return view;
}

bool step_is_changed(const Session &session) {
    const Document &now = session.document;
    if (!now.step) {
        return false;
    }
    const LessonStep &step = now.step->step();
    StepView view = view_of(session.view), meant_view = view_of(step);
    if (view.layout != Layout::difference && view.layout == meant_view.layout) { // what does not show
        view.gain = meant_view.gain;
        view.difference_of = meant_view.difference_of;
    }
    return now.scene != step.scene || now.left != *step.left || now.right != *step.right || now.left_is_textbook() ||
           now.mesh_factors != MeshFactors{step.mesh_factors.x, step.mesh_factors.y} || now.display != step.display ||
           now.exposure != step.exposure || view != meant_view;
}

void restore_step(Session &session) {
    if (step_is_changed(session)) {
        go_to_step(session, session.document.step->number);
    }
}

void follow_step(Session &session, const std::shared_ptr<const ShownStep> &from, bool undone) {
    const auto now = session.document.step;
    if (from == now) {
        return;
    }
    stop_motion(session);
    if (undone && from) {
        set_view(session.view, from->before);
    } else if (now) {
        set_view(session.view, view_of(now->step()));
    }
    if (now) {
        session.progress.last = now->id;
        session.progress.step = now->number;
    }
}

std::optional<glm::dvec3> shown_ring(const Session &session, Size view) {
    const auto &shown = session.document.step;
    if (!shown || session.document.scene.camera != shown->step().scene.camera) {
        return std::nullopt;
    }
    const Scene seen = scene_in_view(shown_document(session), view);
    const auto ring = ring_in_view(shown->step(), seen.camera, view);
    const bool inside = ring && ring->x >= 0 && ring->x <= 1 && ring->y >= 0 && ring->y <= 1 && ring->z <= 1;
    return inside ? ring : std::nullopt;
}

} // namespace sandbox

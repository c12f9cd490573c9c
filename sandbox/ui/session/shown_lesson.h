#pragma once

#include "capture/layout.h"
#include "scene/overlays.h"
#include "teach/lesson.h"

#include <cstddef>
#include <glm/vec3.hpp>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>

/// The lesson that the window shows, step by step.
namespace sandbox {

struct Document;
struct Session;
struct ViewSettings;

/// What a step sets of how the two pictures are shown.
struct StepView {
    Layout layout = Layout::side_by_side;
    double gain = 1;
    DifferenceOf difference_of = DifferenceOf::a_b;
    Overlays drawn_over;
    bool operator==(const StepView &) const = default;
};

/// A step that a document shows.
struct ShownStep {
    std::shared_ptr<const Lesson> lesson;
    std::string id;         ///< by which it is opened again: a built-in name or an absolute path
    std::size_t number = 0; ///< from 0
    StepView before;        ///< what undo goes back to
    [[nodiscard]] const LessonStep &step() const { return lesson->steps[number]; }
};

/// What the settings remember of lessons, by their ids.
struct LessonProgress {
    std::string last; ///< the last one shown; empty: none
    std::size_t step = 0;
    std::map<std::string, std::set<std::size_t>> seen; ///< steps
    bool operator==(const LessonProgress &) const = default;
};

/// A built-in lesson as menus list it.
struct ListedLesson {
    std::string name, title;
    bool bug = false;
};

/// Sets scene, camera, techniques, meshes, layout, display and overlays as the step has them: one edit for undo.
void show_step(Session &session, std::shared_ptr<const Lesson> lesson, const std::string &id, std::size_t number);
/// So many steps on, or back; from bug to bug in the gallery; says where a lesson ends. Does nothing without a lesson.
void go_on(Session &session, int steps);
void go_to_step(Session &session, std::size_t number);
/// What go_on(session, 1) would show; what is shown where there is no next step.
Document next_document(const Session &session);
ViewSettings next_view(const Session &session);
/// Has anything that the step sets been changed?
bool step_is_changed(const Session &session);
/// Sets it again, as one edit.
void restore_step(Session &session);
/// After undo or redo from a document that showed `from`: sets the view as the edit found it or left it.
void follow_step(Session &session, const std::shared_ptr<const ShownStep> &from, bool undone);
/// Where to look in a view of this size, as Marks::ring; none once the camera has moved, nor beyond the view's edges.
std::optional<glm::dvec3> shown_ring(const Session &session, Size view);

} // namespace sandbox

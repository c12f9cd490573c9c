#include "ui/session/taught.h"

#include "teach/lesson_read.h"
#include "teach/marking/exercise_read.h"
#include "ui/session/session.h"

namespace sandbox {

std::shared_ptr<const Lesson> read_lesson(const Session &session, const Assets &assets,
                                          const std::string &name_or_path) {
    return std::make_shared<const Lesson>(open_lesson(name_or_path, assets, session.words));
}

std::shared_ptr<const Exercise> read_exercise(const Session &session, const Assets &assets,
                                              const std::string &name_or_path) {
    return std::make_shared<const Exercise>(open_exercise(name_or_path, assets, session.words));
}

void list_taught(Session &session, const Assets &assets) {
    session.lessons.clear();
    for (const auto read : {builtin_lessons, builtin_bugs}) {
        for (const Lesson &lesson : read(assets, session.words)) {
            session.lessons.push_back({lesson.name, lesson.title.text, lesson.is_bug()});
        }
    }
    session.exercises.clear();
    for (const Exercise &exercise : builtin_exercises(assets, session.words)) {
        session.exercises.push_back({exercise.name, exercise.title.text});
    }
    Document &document = session.document;
    if (const auto shown = document.step) {
        document.step = std::make_shared<const ShownStep>(
            ShownStep{read_lesson(session, assets, shown->id), shown->id, shown->number, shown->before});
    }
    if (const auto shown = document.exercise) {
        document.exercise = std::make_shared<const ShownExercise>(
            ShownExercise{read_exercise(session, assets, shown->id), shown->id, shown->file});
    }
}

} // namespace sandbox

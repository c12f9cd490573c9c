#include "ui/session/shown_exercise.h"

#include "image/error.h"
#include "image/write_files.h"
#include "teach/marking/exercise.h"
#include "teach/marking/student_file.h"
#include "ui/session/session.h"
#include "ui/session/written_files.h"

#include <utility>

namespace sandbox {

namespace fs = std::filesystem;

fs::path student_path(const Exercise &exercise) {
    return fs::absolute(capture_folder() / (exercise.name + ".glsl")).lexically_normal();
}

void show_exercise(Session &session, std::shared_ptr<const Exercise> exercise, const std::string &id,
                   const ShaderParts &parts) {
    const std::string file = student_path(*exercise).string();
    Technique student{.frequency = exercise->target.frequency, .model = Model::own};
    student.own = OwnShader(file, student_file(*exercise, parts));
    session.own_failures.erase(file);
    if (std::error_code absent; fs::exists(file, absent)) {
        try {
            student.own = read_own(file);
        } catch (const InputError &error) {
            session.own_failures[file] = error.what();
        }
    }
    Document document = document_of(exercise->name, exercise->shown_scene(), student, exercise->target);
    document.exercise = std::make_shared<const ShownExercise>(ShownExercise{std::move(exercise), id, file});
    show_document(session, document);
    session.last_own = document.left.own;
    session.view.layout = Layout::side_by_side;
    session.view.masks = false; // they would hide the pictures
}

void write_student_file(const ShownExercise &shown, const ShaderParts &parts) {
    if (std::error_code absent; !fs::exists(shown.file, absent)) {
        write_file(shown.file, student_file(*shown.exercise, parts));
    }
}

} // namespace sandbox

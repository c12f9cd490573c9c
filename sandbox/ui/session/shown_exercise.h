#pragma once

#include "shading/parts.h"

#include <filesystem>
#include <memory>
#include <set>
#include <string>

/// The exercise that the window shows: the student's file as A, what is asked for as B.
namespace sandbox {

struct Exercise;
struct Session;

/// An exercise that a document shows.
struct ShownExercise {
    std::shared_ptr<const Exercise> exercise;
    std::string id;   ///< by which it is opened again: a built-in name or an absolute path
    std::string file; ///< the student's, absolute; it need not be there yet
};

/// As menus list it.
struct ListedExercise {
    std::string name, title;
};

/// What the settings remember of exercises: the ids of those that were solved.
using SolvedExercises = std::set<std::string>;

/// The student's file of an exercise, in the folder of captures. Throws InputError where no folder can be written.
std::filesystem::path student_path(const Exercise &exercise);

/// Shows the first scene: A is the student's file or, while there is none that is accepted, the text to begin with; B
/// is the target. One edit for undo. Throws InputError.
void show_exercise(Session &session, std::shared_ptr<const Exercise> exercise, const std::string &id,
                   const ShaderParts &parts);

/// Writes the file to begin with, unless there is one. Throws InputError.
void write_student_file(const ShownExercise &shown, const ShaderParts &parts);

} // namespace sandbox

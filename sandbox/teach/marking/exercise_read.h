#pragma once

#include "scene/assets.h"
#include "teach/marking/exercise.h"
#include "words/words.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// Exercise files. Every function throws InputError naming the file, the key and what was expected.
namespace sandbox {

/// Reads an exercise by the tables of exercise_format.h. `file` is used in messages and gives the exercise its name;
/// scenes and textures are looked for in `folder`, then among the built-in ones.
Exercise parse_exercise(std::string_view text, const std::filesystem::path &file, const std::filesystem::path &folder,
                        const Assets &assets, const Words &words);

/// The built-in exercises, in their order.
std::vector<Exercise> builtin_exercises(const Assets &assets, const Words &words);

/// The built-in exercise of that name, or the exercise in a .json file.
Exercise open_exercise(const std::string &name_or_file, const Assets &assets, const Words &words);

/// The student's copy, as a file: without what is withheld, every text in the language that it was read in and every
/// scene written out.
std::string student_copy(const Exercise &exercise);

/// The JSON schema of exercise files, made from the reader's own tables.
std::string exercise_schema();

} // namespace sandbox

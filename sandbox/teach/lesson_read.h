#pragma once

#include "scene/assets.h"
#include "teach/lesson.h"
#include "words/words.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// Lesson files. Every function throws InputError naming the file, the key and what was expected.
namespace sandbox {

/// Reads a lesson by the tables of lesson_format.h. `file` is used in messages and gives the lesson its name; scenes
/// and textures are looked for in `folder`, then among the built-in ones. A step without a claim that is checked is
/// refused, unless it says "asserts": false.
Lesson parse_lesson(std::string_view text, const std::filesystem::path &file, const std::filesystem::path &folder,
                    const Assets &assets, const Words &words);

/// The built-in lessons, and the gallery of famous bugs, in their order.
std::vector<Lesson> builtin_lessons(const Assets &assets, const Words &words);
std::vector<Lesson> builtin_bugs(const Assets &assets, const Words &words);

/// The built-in lesson or bug of that name, or the lesson in a .json file.
Lesson open_lesson(const std::string &name_or_file, const Assets &assets, const Words &words);

/// The JSON schema of lesson files, made from the reader's own tables.
std::string lesson_schema();

} // namespace sandbox

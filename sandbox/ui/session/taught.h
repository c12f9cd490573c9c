#pragma once

#include "scene/assets.h"
#include "teach/lesson.h"
#include "teach/marking/exercise.h"

#include <memory>
#include <string>

namespace sandbox {

struct Session;

/// In the window's language. Both throw InputError.
std::shared_ptr<const Lesson> read_lesson(const Session &session, const Assets &assets,
                                          const std::string &name_or_path);
std::shared_ptr<const Exercise> read_exercise(const Session &session, const Assets &assets,
                                              const std::string &name_or_path);

/// Lists the built-in lessons and exercises, and reads the one that is shown again: in the window's language. Throws
/// InputError.
void list_taught(Session &session, const Assets &assets);

} // namespace sandbox

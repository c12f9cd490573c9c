#pragma once

#include "shading/parts.h"
#include "teach/marking/exercise.h"

#include <string>

namespace sandbox {

/// What a student begins with, as GLSL: the task and the interface as comments, and an empty lighting().
std::string student_file(const Exercise &exercise, const ShaderParts &parts);

} // namespace sandbox

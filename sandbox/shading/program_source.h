#pragma once

#include "shading/features.h"
#include "shading/parts.h"

#include <string>
#include <vector>

namespace sandbox {

enum class Stage { vertex, fragment };

/// Where a line of an assembled text came from.
struct LineOrigin {
    std::string part; ///< "light_point.glsl"
    int line = 0;     ///< from 1
};

struct StageSource {
    std::string text;
    std::vector<LineOrigin> origins; ///< one per line of text
};

/// Two texts of GLSL 3.30 core, and GLSL ES 3.00 but for the first lines, that hold what the features say and nothing
/// else.
struct ProgramSource {
    StageSource vertex, fragment;
};

/// Pure: equal features and parts give equal text. `program`: see program_features().
ProgramSource assemble(const Features &program, const ShaderParts &parts);

/// The same stage in GLSL ES 3.00, with high precision everywhere; lines keep their numbers.
StageSource in_es(StageSource source);

/// A compiler log with its line numbers replaced by "part:line" (Mesa's, NVIDIA's and Intel's formats).
std::string map_log(const std::string &log, const StageSource &source);

} // namespace sandbox

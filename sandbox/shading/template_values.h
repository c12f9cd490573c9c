#pragma once

#include "shading/needs.h"
#include "shading/program_source.h"
#include "shading/template.h"

#include <string>
#include <utility>
#include <vector>

namespace sandbox {

/// What the parts may ask of one stage of a program with these features (see program_features()); `needs` are the
/// program's.
TemplateValues template_values(const Features &program, const ProgramNeeds &needs, Stage stage);

/// Makes the values of one stage those of another.
void choose_stage(TemplateValues &values, const Features &program, const ProgramNeeds &needs, Stage stage);

/// What excludes each other: every value of every technique key, and what an object's own features choose. Flags of its
/// specialised program; uniforms of the full one (see uniform_name()), which branches on them.
std::vector<std::pair<std::string, bool>> choices(const Features &object);

} // namespace sandbox

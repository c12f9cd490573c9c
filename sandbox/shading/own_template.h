#pragma once

#include "shading/needs.h"
#include "shading/template.h"

namespace sandbox {

/// What the parts may ask about own shading; of a program that has it, this replaces what template_values() says of
/// lights, points and colours.
void add_own_shading(TemplateValues &values, const Features &program, const ProgramNeeds &needs);

} // namespace sandbox

#pragma once

#include "shading/own_structure.h"

namespace sandbox {

/// Throws InputError where a function leads to itself, and where a function with all that it calls, each as often as it
/// is called, holds more than most_inlined_tokens or most_inlined_loops: drivers put called functions in place of the
/// calls.
void refuse_endless_calls(const OwnStructure &structure);

} // namespace sandbox

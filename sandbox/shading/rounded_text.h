#pragma once

#include "shading/program_source.h"

namespace sandbox {

/// The fragment stage of a specialised program as a half-float device computes it: every operation on floats, every
/// varying, uniform and number goes through h() of math_half.glsl, which the text holds. Lines keep their numbers.
/// Depth and the display map, which are no part of the lighting, stay as they are. Throws std::logic_error for GLSL
/// that no shader part uses.
StageSource with_rounded_operations(StageSource source);

} // namespace sandbox

#pragma once

#include <string>
#include <string_view>

namespace sandbox {

/// How many vectors of four components the uniforms of an assembled stage take at least, packed as GLSL ES 3.00 packs
/// them: an element of a vec3 array has one of its own, in whose fourth component a number may stand.
int uniform_vectors(std::string_view glsl);

/// Why a device with room for `available` vectors cannot draw a stage ("vertex", "fragment") that needs `needed`, and
/// what to try; empty if it can.
std::string uniform_refusal(std::string_view stage, int needed, int available);

} // namespace sandbox

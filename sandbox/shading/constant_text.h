#pragma once

#include "shading/program_source.h"

#include <array>
#include <compare>
#include <map>
#include <string>

namespace sandbox {

/// A uniform of floats as it is uploaded; matrices column by column.
struct UniformValue {
    int count = 0; ///< of the numbers: 1 float, 3 vec3, 9 mat3, 16 mat4
    std::array<float, 16> numbers{};
    auto operator<=>(const UniformValue &) const = default;
};
/// By the names that a program has: "point_lights[0].position".
using UniformValues = std::map<std::string, UniformValue, std::less<>>;

/// The same texts with every uniform that has a finite value here as a constant.
ProgramSource with_constants(ProgramSource source, const UniformValues &values);

} // namespace sandbox

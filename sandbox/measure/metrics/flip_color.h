#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

/// The colour spaces that FLIP works in.
namespace sandbox::flip {

/// An sRGB byte as linear light.
float linear_of(std::uint8_t byte);

/// Linear sRGB to the opponent space YCxCz (a linear map of CIE XYZ under D65) and back.
glm::vec3 opponent_of(const glm::vec3 &linear);
glm::vec3 linear_of_opponent(const glm::vec3 &opponent);

/// CIELAB under D65 with the Hunt effect: chroma grows with lightness (a*, b* times 0.01 L*).
glm::vec3 hunt_lab_of(const glm::vec3 &linear);

/// |dL| + sqrt(da^2 + db^2): large colour differences as people judge them.
float hyab(const glm::vec3 &a, const glm::vec3 &b);

} // namespace sandbox::flip

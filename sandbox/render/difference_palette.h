#pragma once

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec3.hpp>

namespace sandbox {

/// The colours of difference_fragment.glsl, for a scale beside the picture: `value` is gain * (left - right), from -1
/// (right brighter: blue) over 0 (equal: white) to +1 (left brighter: orange).
inline glm::vec3 difference_color(float value) {
    const float t = std::clamp(value, -1.0F, 1.0F);
    const glm::vec3 end = t > 0 ? glm::vec3(0.85F, 0.37F, 0.01F) : glm::vec3(0.13F, 0.35F, 0.75F);
    return glm::mix(glm::vec3(1), end, std::abs(t));
}

} // namespace sandbox

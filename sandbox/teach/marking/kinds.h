#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <span>
#include <string_view>

namespace sandbox {

/// How a term is wrong, as its picture shows it.
enum class ErrorKind {
    missing,    ///< not there at all
    unheeding,  ///< shines whatever its intensity is
    negative,   ///< takes light away
    too_bright, ///< by one factor everywhere
    too_dark,
    color,     ///< by one factor for each channel
    unlit_too, ///< is there where the truth has none
    too_wide,  ///< about as bright at its brightest, but on more pixels
    too_narrow,
    elsewhere,  ///< on other pixels
    everywhere, ///< the same at every pixel, where the truth changes
    not_finite,
    with_camera, ///< moves with the camera
    with_object, ///< turns with the object
    step,        ///< an edge where the truth has none
    shape        ///< none of these
};
inline constexpr std::array<std::string_view, 16> kind_words{
    "missing",    "unheeding", "negative",   "too-bright", "too-dark",    "color",       "unlit-too", "too-wide",
    "too-narrow", "elsewhere", "everywhere", "not-finite", "with-camera", "with-object", "step",      "shape"};

/// Of pixels that are compared: what the answer has, and the truth. Both have as many; `tolerance` is the least
/// difference that shows.
ErrorKind kind_of(std::span<const glm::vec3> answer, std::span<const glm::vec3> truth, double tolerance);

} // namespace sandbox

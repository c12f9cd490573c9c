#pragma once

#include "image/image.h"

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <string>

/// Lines and shapes with soft edges over a picture, in pixels from its upper left corner.
namespace sandbox {

using Rgb = std::array<std::uint8_t, 3>;

void draw_line(ByteImage &view, const glm::dvec2 &a, const glm::dvec2 &b, double width, Rgb color, double opacity = 1);
void draw_disc(ByteImage &view, const glm::dvec2 &center, double radius, Rgb color, double opacity = 1);
/// A convex shape; its corners run clockwise on the screen, no two in one place.
void draw_polygon(ByteImage &view, std::span<const glm::dvec2> corners, Rgb color);
/// A line that is seen on dark and on bright.
void draw_hairline(ByteImage &view, const glm::dvec2 &a, const glm::dvec2 &b, double width);
void draw_ring(ByteImage &view, const glm::dvec2 &center, double radius, double width);
/// With a head; its sizes go by a text of `em` pixels.
void draw_arrow(ByteImage &view, const glm::dvec2 &from, const glm::dvec2 &to, double em, Rgb color);
/// A text with a shadow, its upper left corner there.
void draw_name(ByteImage &view, const glm::dvec2 &at, double em, const std::string &name, Rgb color);

} // namespace sandbox

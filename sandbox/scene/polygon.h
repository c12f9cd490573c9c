#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace sandbox {

/// Indices of a polygon's corners.
using PolygonTriangle = std::array<std::uint32_t, 3>;

/// The most corners of a polygon that is not convex; clipping ears takes time with their square.
constexpr std::size_t most_concave_corners = 10'000;

/// The area times the normal, twice: for a polygon in a plane whatever its shape, for one that is not, of its
/// projection along the normal. Where the sum cancels (a bow tie), that of its first triangle with an area.
glm::dvec3 area_vector(std::span<const glm::dvec3> corners);

/// The triangles of the polygon, which run as its corners do: a fan from the first corner where it is convex, else ears
/// clipped as seen along `area` (its area_vector()). Triangles without area may be among them. A polygon that crosses
/// itself is split somehow. Throws InputError for more than most_concave_corners.
std::vector<PolygonTriangle> split_polygon(std::span<const glm::dvec3> corners, const glm::dvec3 &area);

} // namespace sandbox

#include "scene/polygon.h"

#include "image/error.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <optional>

namespace sandbox {
namespace {

/// Of what was added or of the polygon's area: less is rounding.
constexpr double rounding = 1e-12;

double largest_part(const glm::dvec3 &v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// Twice the signed area of a triangle.
double turn(const glm::dvec2 &a, const glm::dvec2 &b, const glm::dvec2 &c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The corners as seen along the axis nearest to `area`, counter-clockwise, about the first and within 1: no product
/// leaves the range of a double.
std::vector<glm::dvec2> flattened(std::span<const glm::dvec3> corners, const glm::dvec3 &area) {
    const glm::dvec3 size = glm::abs(area);
    const int axis = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    int right = (axis + 1) % 3;
    int up = (axis + 2) % 3;
    if (area[axis] < 0) {
        std::swap(right, up);
    }
    double extent = std::numeric_limits<double>::min();
    for (const glm::dvec3 &corner : corners) {
        extent = std::max(extent, largest_part(corner - corners[0]));
    }
    std::vector<glm::dvec2> flat;
    flat.reserve(corners.size());
    for (const glm::dvec3 &corner : corners) {
        const glm::dvec3 from_first = (corner - corners[0]) / extent;
        flat.emplace_back(from_first[right], from_first[up]);
    }
    return flat;
}

/// No corner turns the other way, and no triangle of the fan does (a star's might).
bool is_convex(const std::vector<glm::dvec2> &p) {
    const std::size_t n = p.size();
    double area = 0;
    for (std::size_t i = 2; i < n; ++i) {
        area += turn(p[0], p[i - 1], p[i]);
    }
    for (std::size_t i = 0; i < n; ++i) {
        const double fan = i >= 2 ? turn(p[0], p[i - 1], p[i]) : 0;
        if (std::min(fan, turn(p[i], p[(i + 1) % n], p[(i + 2) % n])) < -rounding * area) {
            return false;
        }
    }
    return true;
}

std::vector<PolygonTriangle> fan(std::size_t corners) {
    std::vector<PolygonTriangle> triangles;
    triangles.reserve(corners - 2);
    for (std::uint32_t i = 2; i < corners; ++i) {
        triangles.push_back({0, i - 1, i});
    }
    return triangles;
}

/// Cuts off one corner after another whose triangle holds no other corner.
class EarClipper {
  public:
    explicit EarClipper(const std::vector<glm::dvec2> &points) : p_(points) {
        const auto n = static_cast<std::uint32_t>(p_.size());
        for (std::uint32_t i = 0; i < n; ++i) {
            next_.push_back((i + 1) % n);
            before_.push_back((i + n - 1) % n);
        }
        is_ear_.resize(n);
        for (std::uint32_t i = 0; i < n; ++i) {
            if (turn_at(i) <= 0) {
                reflex_.push_back(i);
            }
        }
    }

    std::vector<PolygonTriangle> triangles() {
        std::vector<PolygonTriangle> out;
        out.reserve(p_.size() - 2);
        std::uint32_t at = 0;
        for (std::size_t left = p_.size(); left > 3; --left) {
            const std::uint32_t ear = next_ear(at, left);
            out.push_back({before_[ear], ear, next_[ear]});
            at = cut(ear);
        }
        out.push_back({before_[at], at, next_[at]});
        return out;
    }

  private:
    const std::vector<glm::dvec2> &p_;
    std::vector<std::uint32_t> next_, before_;
    std::vector<std::uint32_t> reflex_;       ///< only these can lie in an ear; some may be gone or reflex no more
    std::vector<std::optional<bool>> is_ear_; ///< changes only beside a corner that is cut

    [[nodiscard]] double turn_at(std::uint32_t i) const { return turn(p_[before_[i]], p_[i], p_[next_[i]]); }

    [[nodiscard]] bool gone(std::uint32_t i) const { return next_[before_[i]] != i; }

    /// The first ear from `at` on. If there is none (rounding, a polygon that crosses itself): a corner on a straight
    /// line, or one that turns the right way, or any.
    std::uint32_t next_ear(std::uint32_t at, std::size_t left) {
        std::uint32_t second = at;
        double best = std::numeric_limits<double>::infinity();
        std::uint32_t i = at;
        for (std::size_t step = 0; step < left; ++step, i = next_[i]) {
            if (!is_ear_[i]) {
                is_ear_[i] = holds_nothing(i);
            }
            if (*is_ear_[i]) {
                return i;
            }
            const double area = turn_at(i);
            if (area >= 0 && area < best) {
                best = area;
                second = i;
            }
        }
        return second;
    }

    [[nodiscard]] bool holds_nothing(std::uint32_t i) {
        const glm::dvec2 &a = p_[before_[i]];
        const glm::dvec2 &b = p_[i];
        const glm::dvec2 &c = p_[next_[i]];
        if (turn(a, b, c) <= 0) {
            return false;
        }
        const glm::dvec2 low = glm::min(glm::min(a, b), c);
        const glm::dvec2 high = glm::max(glm::max(a, b), c);
        return std::ranges::none_of(reflex_, [&](std::uint32_t j) {
            const glm::dvec2 &p = p_[j];
            const bool near = p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y;
            // Corners may stand at one point: a hole's outline is joined to the outer one by an edge there and back.
            return near && p != a && p != b && p != c && turn(a, b, p) >= 0 && turn(b, c, p) >= 0 &&
                   turn(c, a, p) >= 0 && !gone(j);
        });
    }

    /// Returns the corner behind it.
    std::uint32_t cut(std::uint32_t i) {
        const std::uint32_t a = before_[i];
        const std::uint32_t c = next_[i];
        next_[a] = c;
        before_[c] = a;
        is_ear_[a].reset();
        is_ear_[c].reset();
        return c;
    }
};

} // namespace

glm::dvec3 area_vector(std::span<const glm::dvec3> corners) {
    glm::dvec3 sum(0);
    glm::dvec3 first(0);
    double total = 0;
    for (std::size_t i = 2; i < corners.size(); ++i) {
        const glm::dvec3 part = glm::cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
        sum += part;
        total += largest_part(part);
        if (first == glm::dvec3(0)) {
            first = part;
        }
    }
    return largest_part(sum) > rounding * total ? sum : first;
}

std::vector<PolygonTriangle> split_polygon(std::span<const glm::dvec3> corners, const glm::dvec3 &area) {
    if (corners.size() == 3 || area == glm::dvec3(0)) {
        return fan(corners.size());
    }
    const std::vector<glm::dvec2> flat = flattened(corners, area);
    if (is_convex(flat)) {
        return fan(corners.size());
    }
    if (corners.size() > most_concave_corners) {
        throw InputError("expected at most {} corners of a face that is not convex, got {}", most_concave_corners,
                         corners.size());
    }
    return EarClipper(flat).triangles();
}

} // namespace sandbox

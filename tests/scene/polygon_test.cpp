#include "scene/polygon.h"

#include "tools/error_of.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <gtest/gtest.h>
#include <numbers>
#include <random>
#include <string>

namespace sandbox {
namespace {

using Corners = std::vector<glm::dvec3>;

const Corners letter_u{{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {2, 3, 0}, {2, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}};
const Corners arrow{{2, -1, 0}, {0, 3, 0}, {-2, -1, 0}, {0, 1, 0}};
/// A square of side 3 whose hole, of side 1, is joined to it by an edge there and back.
const Corners with_hole{{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}, {0, 0, 0},
                        {1, 1, 0}, {1, 2, 0}, {2, 2, 0}, {2, 1, 0}, {1, 1, 0}};
/// A square with a corner in the middle of each side.
const Corners straight_corners{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}};
/// A comb of five teeth, whose corners stand in lines.
const Corners comb{{0, 0, 0}, {9, 0, 0}, {9, 2, 0}, {8, 2, 0}, {8, 1, 0}, {7, 1, 0}, {7, 2, 0},
                   {6, 2, 0}, {6, 1, 0}, {5, 1, 0}, {5, 2, 0}, {4, 2, 0}, {4, 1, 0}, {3, 1, 0},
                   {3, 2, 0}, {2, 2, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};

/// Every corner turned to the front in turn, both ways round: all triangles run as the polygon does (none lies outside
/// or over another) and together have its area.
void expect_split(Corners corners, double area) {
    for (int way = 0; way < 2; ++way, std::ranges::reverse(corners)) {
        for (std::size_t first = 0; first < corners.size();
             ++first, std::ranges::rotate(corners, corners.begin() + 1)) {
            const glm::dvec3 whole = area_vector(corners);
            ASSERT_NEAR(glm::length(whole) / 2, area, 1e-12 * area);
            double sum = 0;
            const auto triangles = split_polygon(corners, whole);
            ASSERT_EQ(triangles.size(), corners.size() - 2);
            for (const PolygonTriangle &t : triangles) {
                const glm::dvec3 &a = corners[t[0]];
                const glm::dvec3 part = glm::cross(corners[t[1]] - a, corners[t[2]] - a);
                EXPECT_GE(glm::dot(part, whole), -1e-12 * glm::dot(whole, whole)) << "first corner " << first;
                sum += glm::length(part) / 2;
            }
            EXPECT_NEAR(sum, area, 1e-12 * area) << "first corner " << first; // sums of a few dozen products
        }
    }
}

TEST(Polygon, CoversItsAreaOnceWhateverTheFirstCorner) {
    expect_split(letter_u, 7);
    expect_split(arrow, 4);
    expect_split(with_hole, 8);
    expect_split(straight_corners, 4);
    expect_split(comb, 14);
}

TEST(Polygon, CoversItsAreaInAnyPlaneAndAtAnySize) {
    for (const double size : {1e-9, 1.0, 1e9}) {
        for (const glm::dmat3 &axes :
             {glm::dmat3{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}, glm::dmat3{{0, 0, -1}, {0, 1, 0}, {1, 0, 0}},
              glm::dmat3{{0.6, 0.8, 0}, {0, 0, 1}, {0.8, -0.6, 0}}}) {
            Corners turned;
            for (const glm::dvec3 &corner : letter_u) {
                turned.push_back(size * (axes * corner));
            }
            expect_split(turned, 7 * size * size);
        }
    }
}

/// Corners around the origin at random distances: the area is half the sum of r_i r_(i+1) sin(2 pi / n).
TEST(Polygon, CoversTheAreaOfRandomStars) {
    std::mt19937 dice(7);
    for (const std::size_t n : {4U, 5U, 8U, 21U, 60U}) {
        for (int i = 0; i < 20; ++i) {
            std::vector<double> radii;
            Corners corners;
            double area = 0;
            const double step = 2 * std::numbers::pi / static_cast<double>(n);
            for (std::size_t k = 0; k < n; ++k) {
                radii.push_back(std::uniform_real_distribution(0.1, 1.0)(dice));
                const double angle = step * static_cast<double>(k);
                corners.emplace_back(radii[k] * std::cos(angle), radii[k] * std::sin(angle), 0);
            }
            for (std::size_t k = 0; k < n; ++k) {
                area += radii[k] * radii[(k + 1) % n] * std::sin(step) / 2;
            }
            expect_split(corners, area);
        }
    }
}

TEST(Polygon, IsAFanFromTheFirstCornerWhereItIsConvex) {
    const std::vector<PolygonTriangle> fan{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}};
    const Corners house{{1, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 1, 0}, {0, 0, 0}};
    EXPECT_EQ(split_polygon(house, area_vector(house)), fan);
    const Corners saddle{{0, 0, 0}, {1, 0, 0.3}, {1, 1, 0}, {0, 1, 0.3}};
    EXPECT_EQ(split_polygon(saddle, area_vector(saddle)), (std::vector<PolygonTriangle>{{0, 1, 2}, {0, 2, 3}}));
}

TEST(Polygon, IsSplitSomehowWhereItCrossesItselfOrHasNoArea) {
    const Corners bow_tie{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}};
    EXPECT_EQ(area_vector(bow_tie), glm::dvec3(0, 0, -1)) << "the first triangle's: the whole is 0";
    EXPECT_EQ(split_polygon(bow_tie, area_vector(bow_tie)).size(), 2U);
    const Corners line{{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {2, 0, 0}};
    EXPECT_EQ(area_vector(line), glm::dvec3(0));
    EXPECT_EQ(split_polygon(line, area_vector(line)).size(), 2U);
    Corners pentagram;
    for (int i = 0; i < 5; ++i) {
        const double angle = 4 * std::numbers::pi * i / 5;
        pentagram.emplace_back(std::cos(angle), std::sin(angle), 0);
    }
    EXPECT_EQ(split_polygon(pentagram, area_vector(pentagram)).size(), 3U);
}

TEST(Polygon, RefusesTooManyCornersOnlyWhereItIsConcave) {
    const auto wheel = [](std::size_t n, double odd_radius) {
        Corners corners;
        for (std::size_t k = 0; k < n; ++k) {
            const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(n);
            const double radius = k % 2 == 0 ? 1 : odd_radius;
            corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
        }
        return corners;
    };
    const Corners disc = wheel(most_concave_corners + 2, 1);
    EXPECT_EQ(split_polygon(disc, area_vector(disc)).size(), most_concave_corners);
    const Corners cog = wheel(most_concave_corners + 2, 0.5);
    EXPECT_EQ(error_of([&] { split_polygon(cog, area_vector(cog)); }),
              "expected at most 10000 corners of a face that is not convex, got 10002");
}

} // namespace
} // namespace sandbox

#include "reference/raster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <numeric>
#include <random>

namespace sandbox::reference {
namespace {

/// Each triangle as an object of its own, so that coverage can be counted one by one.
struct Triangles {
    std::vector<RasterObject> objects;
    std::vector<glm::uvec3> triangle{{0, 1, 2}};

    void add(Corner a, Corner b, Corner c) { objects.push_back({{a, b, c}, &triangle, false}); }
    [[nodiscard]] std::vector<Hit> draw(Size size, double near = 0.1, double far = 1000) const {
        const Rasteriser rasteriser(objects, size, {near, far});
        std::vector<Hit> all;
        for (std::size_t band = 0; band < rasteriser.bands(); ++band) {
            const std::vector<Hit> hits = rasteriser.draw(band);
            all.insert(all.end(), hits.begin(), hits.end());
        }
        return all;
    }
    /// How many triangles cover each pixel, each drawn alone.
    [[nodiscard]] std::vector<int> coverage(Size size) const {
        std::vector<int> counts(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
        for (const RasterObject &object : objects) {
            Triangles alone;
            alone.objects = {object};
            const std::vector<Hit> hits = alone.draw(size);
            for (std::size_t i = 0; i < hits.size(); ++i) {
                counts[i] += hits[i].object != 0 ? 1 : 0;
            }
        }
        return counts;
    }
};

Corner pixel(double x, double y, double w = 1) { return {x * w, y * w, w}; }

TEST(Raster, TwoTrianglesOfASquareCoverEachPixelOnce) {
    // All edges pass through pixel centres, the diagonal through each centre on it.
    Triangles square;
    square.add(pixel(2.5, 2.5), pixel(12.5, 2.5), pixel(12.5, 12.5));
    square.add(pixel(2.5, 2.5), pixel(12.5, 12.5), pixel(2.5, 12.5));
    const std::vector<int> counts = square.coverage({16, 16});
    for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 16; ++x) {
            // Top and left edges belong to the square, bottom and right ones do not.
            const bool in = x >= 2 && x < 12 && y >= 2 && y < 12;
            EXPECT_EQ(counts[static_cast<std::size_t>(y * 16 + x)], in ? 1 : 0) << x << ' ' << y;
        }
    }
}

/// 1/256 of a pixel is 0.00390625. A triangle that near cuts keeps its corners, for the cut has others.
TEST(Raster, WholeTrianglesLieOnTheWindowsGrid) {
    const std::vector<glm::uvec3> triangles{{0, 1, 2}, {0, 1, 3}};
    RasterObject object;
    object.corners = {pixel(1.001, 2.003, 2), pixel(3.499, 0.002, 4), pixel(7, 5.5, 1), pixel(7, 5.5, 0.5)};
    object.triangles = &triangles;
    object.near = 1;
    object.far = 4;
    EXPECT_EQ(object.triangle(0)[0], pixel(1.001, 2.003, 2));
    object.window_grid = 256;
    const Triangle snapped = object.triangle(0);
    const std::array expected{pixel(1, 2.00390625, 2), pixel(3.5, 0.00390625, 4), pixel(7, 5.5, 1)};
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(glm::distance(snapped[i], expected[i]), 0, 1e-14) << i; // a few roundings of numbers up to 14
    }
    EXPECT_EQ(object.triangle(1)[0], pixel(1.001, 2.003, 2));
}

TEST(Raster, FansOfEitherWindingCoverEachPixelOnce) {
    std::mt19937 random(7);
    std::uniform_int_distribution<int> coordinate(0, 31);
    for (int round = 0; round < 50; ++round) {
        // A fan about a random centre that fills the picture: whatever the winding and depth, exactly one a pixel.
        const Corner centre = pixel(coordinate(random) + 0.5, coordinate(random) + 0.5, 1 + round % 3);
        const Corner rim[] = {pixel(-8.5, -9.5, 2), pixel(40.5, -8.5), pixel(44.5, 41.5, 3), pixel(-7.5, 38.5)};
        Triangles fan;
        for (std::size_t i = 0; i < 4; ++i) {
            const Corner &a = rim[i];
            const Corner &b = rim[(i + 1) % 4];
            (static_cast<std::size_t>(round) + i) % 2 == 0 ? fan.add(centre, a, b) : fan.add(b, a, centre);
        }
        const std::vector<int> counts = fan.coverage({32, 32});
        EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), 0), 32 * 32);
        EXPECT_EQ(*std::max_element(counts.begin(), counts.end()), 1);
    }
}

TEST(Raster, NearerWinsAndTheFirstDrawnWinsATie) {
    Triangles t;
    t.add(pixel(-10, -10, 5), pixel(50, -10, 5), pixel(-10, 50, 5));
    t.add(pixel(-10, -10, 3), pixel(50, -10, 3), pixel(-10, 50, 3));
    t.add(pixel(-10, -10, 3), pixel(50, -10, 3), pixel(-10, 50, 3));
    const Hit hit = t.draw({8, 8})[9];
    EXPECT_EQ(hit.object, 2U);
    EXPECT_TRUE(hit.tie);
    EXPECT_FALSE(hit.own_tie) << "of different objects";
    EXPECT_NEAR(hit.inverse_w, 1.0 / 3, 1e-15);
}

TEST(Raster, ATieWithinAnObject) {
    const std::vector<Corner> twice{pixel(-10, -10, 3), pixel(50, -10, 3), pixel(-10, 50, 3)};
    const std::vector<glm::uvec3> same{{0, 1, 2}, {0, 1, 2}};
    const std::vector<glm::uvec3> one{{0, 1, 2}};
    const auto own_tie = [&](const std::vector<RasterObject> &objects) {
        return Rasteriser(objects, {8, 8}, {1, 10}).draw(0)[9].own_tie;
    };
    EXPECT_TRUE(own_tie({{twice, &same, 0}}));
    EXPECT_TRUE(own_tie({{twice, &same, 0}, {twice, &one, 0}}));
    EXPECT_FALSE(own_tie({{twice, &one, 0}, {twice, &same, 0}})) << "the first object is seen";
    EXPECT_FALSE(own_tie({{twice, &one, 0}, {twice, &one, 0}}));
    // A third surface, a little nearer, that both others lie close to: it may hide its own.
    const std::vector<Corner> nearer{pixel(-10, -10, 2.9999999), pixel(50, -10, 2.9999999), pixel(-10, 50, 2.9999999)};
    EXPECT_FALSE(own_tie({{twice, &one, 0}, {nearer, &one, 0}}));
    EXPECT_TRUE(own_tie({{twice, &one, 0}, {twice, &one, 0}, {nearer, &one, 0}}));
}

TEST(Raster, NearAndFarAreMeasuredAtEachSample) {
    // w grows from 1 at x = 0 to 5 at x = 16 along a slanted plane: 1/w is linear on the screen.
    Triangles t;
    t.add(pixel(0, -100, 1), pixel(16, -100, 5), pixel(0, 200, 1));
    t.add(pixel(16, -100, 5), pixel(16, 200, 5), pixel(0, 200, 1));
    const std::vector<Hit> hits = t.draw({16, 4}, 2, 3);
    for (int x = 0; x < 16; ++x) {
        const double inverse_w = 1 + (x + 0.5) / 16 * (0.2 - 1);
        const bool seen = inverse_w <= 1 / 2.0 && inverse_w >= 1 / 3.0;
        EXPECT_EQ(hits[static_cast<std::size_t>(x)].object != 0, seen) << x;
    }
}

TEST(Raster, TrianglesThatReachBehindTheEyeAreSeenInFrontOnly) {
    // Ground at height -1 under an eye that looks along it, focal length 8 pixels, horizon at y = 8:
    // a row at depth w shows y = 8 + 8 / w, so 1/w = (y - 8) / 8. Two corners lie behind the eye.
    const auto ground = [](double x, double depth) { return Corner{8 * depth + 8 * x, 8 * depth + 8, depth}; };
    Triangles t;
    t.add(ground(-1000, -50), ground(1000, -50), ground(0, 5000));
    const std::vector<Hit> hits = t.draw({16, 16}, 0.1, 1e4);
    for (int y = 0; y < 16; ++y) {
        const Hit &hit = hits[static_cast<std::size_t>(y * 16 + 8)];
        ASSERT_EQ(hit.object != 0, y >= 8) << y;
        if (hit.object != 0) {
            EXPECT_NEAR(hit.inverse_w, (y + 0.5 - 8) / 8, 1e-12);
        }
    }
}

TEST(Raster, WeightsArePerspectiveCorrect) {
    // Halfway on the screen between w = 1 and w = 3 lies a quarter of the way along the edge.
    const glm::dvec3 w = weights_at({pixel(0, 0, 1), pixel(10, 0, 3), pixel(0, 10, 1)}, 5, 0);
    EXPECT_NEAR(w.x, 0.75, 1e-15);
    EXPECT_NEAR(w.y, 0.25, 1e-15);
    EXPECT_NEAR(w.z, 0, 1e-15);
}

TEST(Raster, WeightsOfASmallTriangleFarFromTheWindowsCornerCancel) {
    // The slope of the weight that the corner on the right has is 1 / 2 a pixel: 51 at x = 102, -50 from the corner on.
    EXPECT_NEAR(weights_before_cancelling({pixel(100, 0), pixel(102, 0), pixel(100, 2)}, 101, 0.5), 51, 1e-12);
    EXPECT_EQ(weights_before_cancelling({pixel(0, 0), pixel(100, 0), pixel(0, 100)}, 10, 10), 1); // nothing cancels
}

TEST(Raster, EdgesAreTold) {
    const Triangle t{pixel(0, 0), pixel(10, 0, 4), pixel(0, 10, 2)};
    EXPECT_FALSE(near_edge(t, 3, 3));
    EXPECT_FALSE(near_edge(t, 3, 0.0079));
    EXPECT_TRUE(near_edge(t, 3, 0.0077)); // 1/128 = 0.0078125
    EXPECT_TRUE(near_edge(t, 5, 5.005));
}

TEST(Raster, ANearerNeighbourThatJustMissesIsTold) {
    Triangles t;
    t.add(pixel(-10, -10, 5), pixel(60, -10, 5), pixel(-10, 60, 5));
    t.add(pixel(2.5 + 0.005, -10, 3), pixel(9, -10, 3), pixel(2.5 + 0.005, 30, 3)); // left edge just right of centre 2
    const Rasteriser rasteriser(t.objects, {8, 2}, {0.1, 100});
    const std::vector<Hit> hits = rasteriser.draw(0);
    EXPECT_EQ(hits[2].object, 1U);
    EXPECT_TRUE(rasteriser.beside_wins(hits[2]));
    EXPECT_FALSE(rasteriser.beside_wins(hits[1]));
    EXPECT_EQ(hits[3].object, 2U);
}

TEST(DepthRange, HoldsWhatLiesBetweenThePlanes) {
    const DepthRange depth(2, 8);
    EXPECT_TRUE(depth.holds(1 / 2.0));
    EXPECT_TRUE(depth.holds(1 / 8.0));
    EXPECT_FALSE(depth.holds(1 / 1.9));
    EXPECT_FALSE(depth.holds(1 / 8.1));
}

} // namespace
} // namespace sandbox::reference

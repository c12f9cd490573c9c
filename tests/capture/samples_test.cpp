#include "capture/samples.h"

#include "image/error.h"
#include "scene/space.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>

namespace sandbox {
namespace {

TEST(Samples, OneIsTheCentre) { EXPECT_EQ(sample_offset(0, 1), glm::dvec2(0)); }

TEST(Samples, StandOneInEveryRowAndColumnAroundTheCentre) {
    for (const int count : {2, 4, 16, 64, 256}) {
        std::set<double> xs, ys;
        glm::dvec2 sum(0);
        for (int i = 0; i < count; ++i) {
            const glm::dvec2 offset = sample_offset(i, count);
            EXPECT_LT(std::max(std::abs(offset.x), std::abs(offset.y)), 0.5);
            xs.insert((offset.x + 0.5) * count - 0.5); // powers of two: exact
            ys.insert((offset.y + 0.5) * count - 0.5);
            sum += offset;
        }
        std::set<double> all;
        for (int i = 0; i < count; ++i) {
            all.insert(i);
        }
        EXPECT_EQ(xs, all);
        EXPECT_EQ(ys, all);
        EXPECT_EQ(sum, glm::dvec2(0));
    }
}

/// White where the picture's edge at `edge` pixels from the left, moved as the camera says, leaves a centre to its
/// left.
Image half_plane(const Scene &scene, Size size, double edge) {
    Image image(size, glm::vec4(0, 0, 0, 1));
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const double moved = edge + scene.camera.picture_shift.x * size.width / 2;
            image.pixels[image.index(x, y)] = glm::vec4(x + 0.5 < moved ? 1.0f : 0.0f);
        }
    }
    return image;
}

TEST(Samples, ShowAnEdgeAsTheShareThatItCovers) {
    const Size size{8, 3};
    for (const int count : {1, 4, 7, 16}) {
        const Image mean =
            draw_samples({}, size, count, [&](const Scene &scene) { return half_plane(scene, size, 3.3); });
        EXPECT_EQ(mean.pixels[mean.index(2, 1)].x, 1);
        EXPECT_NEAR(mean.pixels[mean.index(3, 1)].x, 0.3, 0.5 / count + 1e-6); // a step's half: one in each column
        EXPECT_EQ(mean.pixels[mean.index(4, 1)].x, 0);
    }
}

TEST(Samples, TheCamerasShiftMovesWhatIsSeen) {
    Camera camera;
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        camera.projection = projection;
        camera.height = projection == Projection::orthographic ? 3 : 0;
        const glm::dvec4 p(0.3, -0.2, -4, 1);
        camera.picture_shift = {0, 0};
        const glm::dvec4 still = view_projection(camera, 1.5) * p;
        camera.picture_shift = {0.25, -0.125};
        const glm::dvec4 moved = view_projection(camera, 1.5) * p;
        EXPECT_NEAR(moved.x / moved.w - still.x / still.w, 0.25, 1e-15);
        EXPECT_NEAR(moved.y / moved.w - still.y / still.w, -0.125, 1e-15);
        EXPECT_EQ(moved.z, still.z);
        EXPECT_EQ(moved.w, still.w);
    }
}

TEST(Samples, AreAWholeNumber) {
    EXPECT_EQ(checked_samples(256), 256);
    for (const double bad : {0.0, -1.0, 1.5, 257.0}) {
        EXPECT_THROW(checked_samples(bad), InputError) << bad;
    }
}

} // namespace
} // namespace sandbox

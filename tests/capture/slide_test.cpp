#include "capture/slide.h"

#include <gtest/gtest.h>

namespace sandbox {
namespace {

LessonStep step_with_ring() {
    LessonStep step;
    step.left = step.right = Technique{};
    step.look = LookHere{{0.75, 0.25}, 0.1};
    return step;
}

/// The view of a slide has the ring where the lesson says.
TEST(Slide, TheRingOfAViewOfItsOwnSizeIsTheSlides) {
    for (const StepLayout layout : {StepLayout::side_by_side, StepLayout::single, StepLayout::three_up}) {
        LessonStep step = step_with_ring();
        step.layout = layout;
        const PictureOptions slide = slide_options(step);
        const Size own = view_sizes(slide.layout, room_for_views(slide)).front();
        const auto ring = ring_in_view(step, step.scene.camera, own);
        ASSERT_TRUE(ring);
        EXPECT_NEAR(ring->x, 0.75, 1e-12);
        EXPECT_NEAR(ring->y, 0.25, 1e-12);
        EXPECT_NEAR(ring->z, 0.1, 1e-12);
    }
}

/// Twice as wide for its height, the same place is half as far from the middle, and as high; seen at twice the
/// tangent of the angle, everything is half as far and half as large.
TEST(Slide, TheRingStaysOverItsPlace) {
    LessonStep step = step_with_ring();
    step.scene.camera.fov_y_degrees = 90; // tangent of the half: 1
    step.layout = StepLayout::single;
    const PictureOptions slide = slide_options(step);
    const Size own = room_for_views(slide);
    const auto wide = ring_in_view(step, step.scene.camera, {2 * own.width, own.height});
    EXPECT_NEAR(wide->x, 0.625, 1e-12);
    EXPECT_NEAR(wide->y, 0.25, 1e-12);
    EXPECT_NEAR(wide->z, 0.1, 1e-12);
    Camera far = step.scene.camera;
    far.fov_y_degrees = 2 * 63.43494882292201; // tangent of the half: 2
    const auto small = ring_in_view(step, far, own);
    EXPECT_NEAR(small->x, 0.625, 1e-9);
    EXPECT_NEAR(small->y, 0.375, 1e-9);
    EXPECT_NEAR(small->z, 0.05, 1e-9);
    step.look.reset();
    EXPECT_FALSE(ring_in_view(step, far, own));
}

} // namespace
} // namespace sandbox

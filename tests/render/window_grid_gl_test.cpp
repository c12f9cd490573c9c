#include "render/window_grid.h"

#include "render/renderer.h"
#include "tools/gl_test.h"

#include <cmath>

namespace sandbox {
namespace {

class WindowGrid : public GlTest {};

/// A picture that slides with the camera's shift, rounded to `steps` a pixel.
DrawPicture sliding(double steps) {
    return [steps](const Scene &scene, const Technique & /*technique*/, Size size) {
        const double pixels = scene.camera.picture_shift.x * size.width / 2;
        const auto moved = static_cast<float>(steps > 0 ? std::round(pixels * steps) / steps : pixels);
        return Image(size, glm::vec4(moved));
    };
}

TEST_F(WindowGrid, IsFoundByWhatDoesNotMove) {
    GLint bits = 0;
    glGetIntegerv(GL_SUBPIXEL_BITS, &bits);
    EXPECT_EQ(measured_window_grid(sliding(1 << bits)), 1 << bits);
    EXPECT_EQ(measured_window_grid(sliding(0)), 0);
    EXPECT_EQ(measured_window_grid([](const Scene &, const Technique &, Size size) { return Image(size); }), 0)
        << "a picture that shows nothing";
}

/// Mesa's software renderers are not asked, because they round nothing that is interpolated.
TEST_F(WindowGrid, IsWhatTheRendererTakesItFor) {
    Renderer renderer(Assets("assets"), ShaderParts(Assets("shaders")));
    const int found = measured_window_grid([&](const Scene &scene, const Technique &technique, Size size) {
        return renderer.render(scene, technique, size).color;
    });
    Scene scene;
    scene.objects.emplace_back();
    EXPECT_EQ(found, renderer.resources().load(scene).front().window_grid);
    EXPECT_TRUE(found == 0 || !Context::software()) << found;
}

} // namespace
} // namespace sandbox

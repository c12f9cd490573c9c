#include "render/window_grid.h"

#include "render/gl.h"

namespace sandbox {
namespace {

constexpr Size size{8, 8};

/// A square that fills the picture, its corners on those of pixels, lit at one corner more than at the others.
Scene square(double shift_in_pixels) {
    Scene scene;
    scene.camera.position = {0, 2, 0};
    scene.camera.target = {0, 0, 0};
    scene.camera.up = {0, 0, -1};
    scene.camera.projection = Projection::orthographic;
    scene.camera.height = 2;
    scene.camera.picture_shift.x = 2 * shift_in_pixels / size.width;
    Light light;
    light.position = {1, 1, 1};
    scene.lights.push_back(light);
    Object object;
    object.mesh = PlaneShape{};
    scene.objects.push_back(object);
    return scene;
}

} // namespace

int measured_window_grid(const DrawPicture &draw) {
    GLint bits = 0;
    glGetIntegerv(GL_SUBPIXEL_BITS, &bits);
    const int steps = 1 << bits;
    const Technique technique{Frequency::per_vertex, Model::lambert};
    const auto moved_by = [&](double steps_moved) { return draw(square(steps_moved / steps), technique, size).pixels; };
    const auto still = moved_by(0);
    return moved_by(0.3) == still && moved_by(1) != still ? steps : 0;
}

} // namespace sandbox

#include "render/renderer.h"
#include "shading/eye_space.h"
#include "tools/gl_test.h"

namespace sandbox {
namespace {

constexpr Size size{320, 240};
constexpr glm::vec3 line_color{3, 5, 7}; // nothing in the scene is so bright

/// A ball before a box on a floor that reaches to the horizon: lines seen, lines hidden, lines at a grazing angle.
Scene ball_before_box() {
    Scene scene;
    scene.camera.position = {0.3, 0.6, 4};
    scene.camera.near_plane = 0.5;
    scene.camera.far_plane = 60;
    scene.ambient = glm::dvec3(0.2);
    scene.objects = {{"ball", SphereShape{0.6, 12, 24}, {{0.2, 0, 1}, {}, glm::dvec3(1)}, {}, false},
                     {"box", BoxShape{{2, 2, 2}, 8}, {{-0.2, 0, -1}, {0, 20, 0}, glm::dvec3(1)}, {}, false},
                     {"floor", PlaneShape{{60, 60}, 16}, {{0, -1, 0}, {}, glm::dvec3(1)}, {}, false}};
    return scene;
}

class Wireframe : public GlTest {
  protected:
    std::vector<bool> lines(const Scene &scene) {
        Target target(size);
        renderer_.draw(scene, parse_technique("per-pixel/lambert"), target);
        renderer_.draw_wireframe(scene, target, line_color);
        std::vector<bool> on_line;
        for (const glm::vec4 &pixel : target.read_color().pixels) {
            on_line.push_back(glm::vec3(pixel) == line_color);
        }
        return on_line;
    }
    Renderer renderer_{Assets("assets"), ShaderParts(Assets("shaders"))};
};

TEST_F(Wireframe, IsTheSameInDeepScenes) {
    const Scene usual = ball_before_box();
    Scene deep = usual;
    deep.camera.near_plane = 1e-4;
    deep.camera.far_plane = 1e6; // cuts no more away: the floor ends before
    ASSERT_FALSE(is_deep(usual.camera));
    ASSERT_TRUE(is_deep(deep.camera));
    const std::vector<bool> expected = lines(usual);
    const std::vector<bool> got = lines(deep);
    std::ptrdiff_t seen = 0, missing = 0, added = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        seen += expected[i] ? 1 : 0;
        missing += expected[i] && !got[i] ? 1 : 0;
        added += !expected[i] && got[i] ? 1 : 0;
    }
    EXPECT_GT(seen, 5000);
    // The lines are lifted by other rules, which differ where surfaces meet or are seen edge-on.
    EXPECT_LT(missing, seen / 50);
    EXPECT_LT(added, seen / 50);
}

} // namespace
} // namespace sandbox

#include "measure/metrics/metrics.h"
#include "render/renderer.h"
#include "scene/orbit.h"
#include "scene/scene_file.h"
#include "tools/feature_scenes.h"
#include "tools/gl_test.h"

#include <numbers>

/// The orthographic camera on the renderer, against the truth.
namespace sandbox {
namespace {

constexpr Size size{96, 72};

class OrthographicOnTheRenderer : public GlTest {
  protected:
    double error(const Scene &scene, const Technique &technique, std::size_t least = 600) {
        const ReferenceFrame truth = render_reference(scene, renderer_.resources().load(scene), technique, size);
        const Metrics metrics = compare(renderer_.render(scene, technique, size, true), truth, Flip::without);
        EXPECT_EQ(metrics.nonfinite_pixels, 0U);
        EXPECT_EQ(metrics.silhouette_pixels, 0U) << scene.name << ", " << to_string(technique);
        EXPECT_GE(metrics.compared_pixels, least) << scene.name << ", " << to_string(technique);
        return metrics.norms.max_abs;
    }
    Renderer renderer_{Assets("assets"), ShaderParts(Assets("shaders"))};
};

/// 5e-5 + 4e-7 n for textbook powers, as everywhere (n = 32; the stiff scene's form is the stable one).
TEST_F(OrthographicOnTheRenderer, IsTheTruthUnderEveryFrequencyModelAndProgram) {
    for (Scene scene : feature_scenes()) {
        scene.camera = with_projection(scene.camera, Projection::orthographic);
        scene.camera.height = 3;
        for (const Frequency frequency : all_frequencies) {
            for (const Model model : all_models) {
                for (const Program program : {Program::specialised, Program::full}) {
                    if (frequency == Frequency::interpolated_vectors && scene.lights.size() > 3) {
                        continue; // more than its varyings carry
                    }
                    const Technique technique{.frequency = frequency, .model = model, .program = program};
                    EXPECT_LE(error(scene, technique), 6.3e-5) << scene.name << ", " << to_string(technique);
                }
            }
        }
    }
}

TEST_F(OrthographicOnTheRenderer, TheViewersFaultsAreTheTruth) {
    for (const char *technique : {"per-pixel/phong:position=w0", "per-pixel/blinn-phong:half_vector=constant",
                                  "per-vertex/phong:gate=view-facing",
                                  "interpolated-vectors/blinn-phong:viewer=infinite", "per-pixel/phong:facing=view"}) {
        for (Scene scene : feature_scenes()) {
            if (scene.lights.size() <= 3) {
                scene.camera = with_projection(scene.camera, Projection::orthographic);
                scene.camera.height = 3;
                EXPECT_LE(error(scene, parse_technique(technique)), 6.3e-5) << scene.name << ", " << technique;
            }
        }
    }
}

/// Depth stays linear, however far apart near and far are.
TEST_F(OrthographicOnTheRenderer, NoDepthIsALogarithm) {
    Scene scene = feature_scenes()[2];
    scene.camera = with_projection(scene.camera, Projection::orthographic);
    scene.camera.near_plane = 1e-6;
    scene.camera.far_plane = 100;
    EXPECT_LE(error(scene, parse_technique("per-pixel/phong")), 5e-5);
}

/// By hand: the middle of a plane that faces the camera, a directional light at 30 degrees: N.L and N.H are cosines.
TEST_F(OrthographicOnTheRenderer, AHighlightIsEvenOverAPlane) {
    Scene scene;
    scene.camera = {.position = {0, 5, 0}, .up = {0, 0, -1}};
    scene.camera = with_projection(scene.camera, Projection::orthographic);
    scene.objects = {{"floor", PlaneShape{{20, 20}, 2}, {}, {}, false}};
    Light light;
    light.type = LightType::directional;
    light.direction = {-std::sin(std::numbers::pi / 6), -std::cos(std::numbers::pi / 6), 0};
    scene.lights = {light};
    const Frame frame = renderer_.render(scene, parse_technique("per-pixel/blinn-phong"), size);
    const double expected = std::cos(std::numbers::pi / 6) + std::pow(std::cos(std::numbers::pi / 12), 32);
    for (const glm::vec4 &pixel : frame.color.pixels) {
        EXPECT_NEAR(pixel.r, expected, 1e-5);
    }
}

} // namespace
} // namespace sandbox

#include "measure/metrics/metrics.h"
#include "render/renderer.h"
#include "scene/scene_file.h"
#include "tools/gl_test.h"

#include <vector>

/// two_sided in GLSL: by gl_FrontFacing, at the vertices for both sides, and under facing=view by N.V.
namespace sandbox {
namespace {

constexpr Size size{96, 72};

/// An open pipe, seen inside and outside, with coarse slices; a tilted, mirrored square; a light on either side.
Scene open_meshes() {
    Scene scene;
    scene.name = "open meshes";
    scene.camera.position = {0.4, 2.2, 3};
    scene.ambient = {0.05, 0.05, 0.1};
    CylinderShape pipe{0.7, 1.1, 9, 2};
    pipe.caps = false;
    scene.objects = {{"pipe", pipe, {}, {}, true}, {"square", PlaneShape{{1.6, 1.2}, 3}, {}, {}, true}};
    scene.objects[0].transform.translate = {-0.7, 0, 0};
    scene.objects[1].transform = {{1.1, 0.2, -0.3}, {115, 20, 0}, {-1, 1, 1.5}};
    scene.objects[1].material.texture = "tiles.png";
    scene.objects[1].material.texture_modulates_specular = false;
    Light left;
    left.position = {-2, 3, 2};
    left.attenuation = {0.5, 0.1, 0.02};
    left.ambient = 0.1;
    left.attenuate_ambient = true;
    Light behind;
    behind.type = LightType::directional;
    behind.direction = {0.3, 0.2, 1};
    scene.lights = {left, behind};
    return scene;
}

class FacingOnTheRenderer : public GlTest {
  protected:
    double error(const Scene &scene, const Technique &technique) {
        const ReferenceFrame truth = render_reference(scene, renderer_.resources().load(scene), technique, size);
        const Metrics metrics = compare(renderer_.render(scene, technique, size, true), truth, Flip::without);
        EXPECT_EQ(metrics.nonfinite_pixels, 0U);
        EXPECT_GT(metrics.compared_pixels, 1500U);
        return metrics.norms.max_abs;
    }
    Renderer renderer_{Assets("assets"), ShaderParts(Assets("shaders"))};
};

/// 5e-5: the bound of random scenes (n = 32: 2e-5 + 1.3e-5, and interpolation over slivers).
TEST_F(FacingOnTheRenderer, IsTheTruthUnderEveryFrequencyModelAndProgram) {
    const Scene scene = open_meshes();
    for (const Frequency frequency : all_frequencies) {
        for (const Model model : all_models) {
            for (const Facing facing : {Facing::winding, Facing::view}) {
                for (const Program program : {Program::specialised, Program::full}) {
                    const Technique technique{
                        .frequency = frequency, .model = model, .facing = facing, .program = program};
                    EXPECT_LE(error(scene, technique), 5e-5) << to_string(technique);
                }
            }
        }
    }
}

TEST_F(FacingOnTheRenderer, TheCaseHasItsRightValue) {
    const Scene scene = open_scene(TEST_DATA_DIR "/lighting/two_sided_ball.json", Assets("assets"));
    const auto pixel = [&](const char *technique) {
        return renderer_.render(scene, parse_technique(technique), {320, 240}).color.at(231, 118).x;
    };
    EXPECT_NEAR(pixel("per-pixel/blinn-phong"), 0.15, 1e-6);
    EXPECT_NEAR(pixel("per-pixel/blinn-phong:facing=view"), 1.352, 1e-3);
}

/// Seen from outside, nothing may change on a closed mesh; to the last bit, because it is the same arithmetic.
TEST_F(FacingOnTheRenderer, AClosedMeshIsTheSameTwoSided) {
    Scene scene = open_meshes();
    scene.objects = {{"ball", SphereShape{1, 7, 9}, {}, {}, false}};
    for (const Frequency frequency : all_frequencies) {
        const Technique technique{.frequency = frequency, .model = Model::phong};
        scene.objects[0].two_sided = false;
        const Frame one = renderer_.render(scene, technique, size);
        scene.objects[0].two_sided = true;
        EXPECT_EQ(one.color.pixels, renderer_.render(scene, technique, size).color.pixels) << to_string(technique);
    }
}

} // namespace
} // namespace sandbox
